/** Cameras that share what they see, predict where targets will be, and divide them up. */
package org.hificamsim.agents.cooperative;
