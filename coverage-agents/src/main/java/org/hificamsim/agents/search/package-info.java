/**
 * Exact search: one detection set for each camera so that an objective is best. Begin with {@link
 * org.hificamsim.agents.search.StepSolver}.
 */
package org.hificamsim.agents.search;
