/**
 * Comparisons of many plans: their runs, which may be interrupted and resumed ({@link
 * org.hificamsim.runs.compare.JournalledEngine}), and statistics.
 */
package org.hificamsim.runs.compare;
