/**
 * Policies that do not learn: the baselines of thesis 7.4.2, and greedy, tracker and patrol, which
 * people expect of cameras that turn.
 */
package org.hificamsim.agents.baseline;
