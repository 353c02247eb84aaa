/** Runs of CamSim under the bridge: cameras look and zoom by our rules, and results are written. */
package org.hificamsim.bridge.run;
