/** Multi-armed bandits: one for each camera, with its views as arms (thesis 7.4.3). */
package org.hificamsim.agents.bandit;
