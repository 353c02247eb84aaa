/** Multi-armed bandits, one per camera with its zoom levels as arms (section 7.4.3). */
package org.hificamsim.agents.bandit;
