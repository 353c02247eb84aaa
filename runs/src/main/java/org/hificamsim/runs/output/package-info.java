/** Result files: written beside their place and moved there when all is well. */
package org.hificamsim.runs.output;
