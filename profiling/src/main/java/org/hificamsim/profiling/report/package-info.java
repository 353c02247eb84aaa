/** The report: the thesis's tables and figures of chapters 3 to 6 beside a data set's own. */
package org.hificamsim.profiling.report;
