/**
 * The most that cameras can score when their moves take time and everything is known in advance: a
 * plan of all ways, and a bound by Lagrangian decomposition into steps and ways.
 */
package org.hificamsim.agents.ways;
