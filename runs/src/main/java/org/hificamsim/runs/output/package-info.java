/** Result files: written next to their place and moved there when all is well. */
package org.hificamsim.runs.output;
