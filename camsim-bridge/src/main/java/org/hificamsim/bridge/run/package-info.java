/** A run of CamSim under the bridge: its live network, who looks, who zooms, what is written. */
package org.hificamsim.bridge.run;
