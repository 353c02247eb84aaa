/** The detection rules that CamSim and the coverage study used. */
package org.hificamsim.core.detection.camsim;
