/** A run: what is to be run, its settings, its results. */
package org.hificamsim.runs;
