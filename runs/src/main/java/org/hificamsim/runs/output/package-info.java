/** Result files: their declarations, writers and readers. */
package org.hificamsim.runs.output;
