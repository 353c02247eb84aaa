package org.hificamsim.core.scenario;

import java.util.List;
import java.util.Optional;
import org.hificamsim.core.obstacle.Obstacle;

/**
 * What is in the field besides cameras and targets.
 *
 * @param obstacles in file order
 * @param floorplan drawn under the field
 */
public record Surroundings(
    List<Obstacle> obstacles, Occlusion occlusion, Optional<Floorplan> floorplan) {
  /** An open field. */
  public static final Surroundings NONE =
      new Surroundings(List.of(), Occlusion.NONE, Optional.empty());

  /** The same without a picture under it. */
  public Surroundings withoutFloorplan() {
    return new Surroundings(obstacles, occlusion, Optional.empty());
  }

  /** The same with other obstacles. */
  public Surroundings with(List<Obstacle> others) {
    return new Surroundings(others, occlusion, floorplan);
  }

  /** The same with another occlusion. */
  public Surroundings with(Occlusion other) {
    return new Surroundings(obstacles, other, floorplan);
  }

  /** Copies what could change. */
  public Surroundings {
    obstacles = List.copyOf(obstacles);
  }
}
