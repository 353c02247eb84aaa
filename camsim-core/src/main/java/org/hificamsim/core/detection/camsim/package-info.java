/** The detection rules that CamSim and the coverage study used. */
@StableApi(since = "0.1")
package org.hificamsim.core.detection.camsim;

import org.hificamsim.core.StableApi;
