/** How a camera picks among its views: ties, exploration, randomness of its own. */
package org.hificamsim.agents.choice;
