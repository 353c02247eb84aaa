/** How targets move: CamSim's four movements and the coverage study's scripted one. */
package org.hificamsim.core.world.movement;
