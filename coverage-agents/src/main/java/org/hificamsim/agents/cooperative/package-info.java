/**
 * Cameras that share what they see, predict where targets will be, and divide them up: begin with
 * {@link org.hificamsim.agents.cooperative.CooperativeZoomPolicy}.
 */
package org.hificamsim.agents.cooperative;
