/**
 * Policies that do not learn: the baselines of thesis 7.4.2, and greedy, tracker and patrol, which
 * are usual for cameras that can turn.
 */
package org.hificamsim.agents.baseline;
