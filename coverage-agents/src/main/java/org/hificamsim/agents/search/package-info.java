/** Exact search: one detection set for each camera so that an objective is best. */
package org.hificamsim.agents.search;
