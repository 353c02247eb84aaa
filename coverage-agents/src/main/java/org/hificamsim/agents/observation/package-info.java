/**
 * What a camera knows before it decides, as numbers for a learner: layout, bounds, and how they are
 * found.
 */
package org.hificamsim.agents.observation;
