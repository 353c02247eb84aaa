/** The few classes of the bridge that CamSim's class loader sees: the agent and the hooks. */
package org.hificamsim.bridge.agent;
