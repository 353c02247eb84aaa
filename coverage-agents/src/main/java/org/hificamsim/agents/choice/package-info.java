/** How a camera picks among its levels: ties, exploration, randomness of its own. */
package org.hificamsim.agents.choice;
