/** Bandits: learning which schedule and policy, or which range, serves a camera best. */
package org.hificamsim.network.bandit;
