/** Multi-armed bandits, one per camera with its views as arms (thesis 7.4.3). */
package org.hificamsim.agents.bandit;
