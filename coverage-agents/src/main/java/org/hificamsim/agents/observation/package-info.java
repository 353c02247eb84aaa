/**
 * The knowledge of a camera before it decides, as numbers for learners: their layout, bounds and
 * computation.
 */
package org.hificamsim.agents.observation;
