/**
 * What a camera knows before it decides, as numbers for a learner: their layout, their bounds, and
 * how they are computed.
 */
package org.hificamsim.agents.observation;
