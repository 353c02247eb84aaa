/** Policies that neither know nor learn: the baselines of section 7.4.2. */
package org.hificamsim.agents.baseline;
