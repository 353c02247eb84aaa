/**
 * The rules by which a camera chooses among its views: ties, exploration, utility, and its own
 * random numbers.
 */
package org.hificamsim.agents.choice;
