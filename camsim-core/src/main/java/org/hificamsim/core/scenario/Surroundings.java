package org.hificamsim.core.scenario;

import java.util.List;
import java.util.Optional;
import org.hificamsim.core.detection.Conditions;
import org.hificamsim.core.obstacle.Obstacle;

/**
 * What is in the field besides cameras and targets.
 *
 * @param obstacles in file order
 * @param floorplan drawn under the field
 * @param conditions of every camera that does not say its own
 */
public record Surroundings(
    List<Obstacle> obstacles,
    Occlusion occlusion,
    Optional<Floorplan> floorplan,
    Conditions conditions) {
  /** An open field. */
  public static final Surroundings NONE =
      new Surroundings(List.of(), Occlusion.NONE, Optional.empty());

  /** Where nothing is known of the conditions. */
  public Surroundings(
      List<Obstacle> obstacles, Occlusion occlusion, Optional<Floorplan> floorplan) {
    this(obstacles, occlusion, floorplan, Conditions.UNKNOWN);
  }

  /** The same without a picture under it. */
  public Surroundings withoutFloorplan() {
    return new Surroundings(obstacles, occlusion, Optional.empty(), conditions);
  }

  /** The same with other obstacles. */
  public Surroundings with(List<Obstacle> others) {
    return new Surroundings(others, occlusion, floorplan, conditions);
  }

  /** The same with another occlusion. */
  public Surroundings with(Occlusion other) {
    return new Surroundings(obstacles, other, floorplan, conditions);
  }

  /** Copies what could change. */
  public Surroundings {
    obstacles = List.copyOf(obstacles);
  }
}
