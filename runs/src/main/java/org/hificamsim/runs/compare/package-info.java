/** Comparisons of many plans: their runs, which may be interrupted and resumed, and statistics. */
package org.hificamsim.runs.compare;
