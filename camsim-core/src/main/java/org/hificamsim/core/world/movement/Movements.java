package org.hificamsim.core.world.movement;

import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.world.Movement;

/** The movements that come with the simulator. */
public final class Movements {
  private Movements() {}

  /** Adds the built-in movements to a registry. */
  public static Registry<Movement> register(Registry<Movement> registry) {
    return registry
        .register("Straight", "straight line, turning at the border", StraightMovement::new)
        .register("Waypoints", "CamSim's closed path, full steps", WaypointsMovement::new)
        .register("Scripted", "the coverage study's closed path, exact", ScriptedMovement::new)
        .register("Brownian", "random walk of given mean and std", BrownianMovement::new)
        .register("DirectedBrownian", "wandering line", DirectedBrownianMovement::new)
        .register(
            "RandomWaypoint",
            "straight to random places, around obstacles",
            RandomWaypointMovement::new)
        .register("Tracks", "recorded tracks, of a <tracks> element", TracksMovement::new);
  }

  /** A registry of the built-in movements and those in users' jars. */
  public static Registry<Movement> registry() {
    return register(new Registry<>("movement"))
        .registerServices(Movement.class, Movement::name, (movement, options) -> {});
  }
}
