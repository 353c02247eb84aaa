/** Connects the bridge with CamSim: checks its methods, weaves hooks into them, and calls them. */
package org.hificamsim.bridge.camsim;
