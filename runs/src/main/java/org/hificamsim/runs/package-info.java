/** A run: its plan, its settings, its metrics and results. */
package org.hificamsim.runs;
