/** Scenario files: CamSim's XML and the coverage study's dialect, read, checked and written. */
@StableApi(since = "0.1")
package org.hificamsim.core.scenario;

import org.hificamsim.core.StableApi;
