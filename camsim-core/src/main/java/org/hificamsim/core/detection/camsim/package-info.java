/** The detection models of CamSim and of the coverage study. */
@StableApi(since = "0.1")
package org.hificamsim.core.detection.camsim;

import org.hificamsim.core.StableApi;
