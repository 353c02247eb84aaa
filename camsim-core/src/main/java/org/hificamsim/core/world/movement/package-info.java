/** How targets move: CamSim's four movements and the coverage study's scripted one. */
@StableApi(since = "0.1")
package org.hificamsim.core.world.movement;

import org.hificamsim.core.StableApi;
