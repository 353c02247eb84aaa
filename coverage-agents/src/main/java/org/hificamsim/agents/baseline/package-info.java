/** Policies that neither know nor learn: the baselines of thesis 7.4.2. */
package org.hificamsim.agents.baseline;
