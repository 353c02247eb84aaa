package org.hificamsim.tracks;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.scenario.spec.Floorplan;

/**
 * Settings of an imported scenario: name, field, walls, floor plan, cameras.
 *
 * @param name name of the scenario
 * @param source the recording, whose name is in a comment
 * @param cameras the number of cameras to place as a first draft
 * @param margin margin of the field around all samples, in metres
 * @param step the length of a step, in seconds; the time between two samples by default
 * @param walls the walls and solids, in metres
 * @param floorplan the picture's name in the scenario's folder and the area that it shows
 */
public record SiteSettings(
    String name,
    Path source,
    int cameras,
    OptionalDouble margin,
    OptionalDouble step,
    List<Obstacle> walls,
    Optional<Floorplan> floorplan) {
  /** Copies mutable lists. */
  public SiteSettings {
    walls = List.copyOf(walls);
  }
}
