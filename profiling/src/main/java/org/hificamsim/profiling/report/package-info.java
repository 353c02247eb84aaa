/** The report: a data set's own tables and figures, and those of the thesis's chapters 3 to 6. */
package org.hificamsim.profiling.report;
