/**
 * Exact max-min coverage: one detection set per camera so that the least covered target is best.
 */
package org.hificamsim.agents.search;
