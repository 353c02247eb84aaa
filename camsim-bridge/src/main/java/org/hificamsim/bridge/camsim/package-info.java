/** CamSim as the bridge sees it: the names that must be there, the hooks, the calls. */
package org.hificamsim.bridge.camsim;
