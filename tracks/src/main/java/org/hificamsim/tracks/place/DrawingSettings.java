package org.hificamsim.tracks.place;

import java.util.Optional;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.LocalProjection;

/**
 * Settings for reading a drawing or map.
 *
 * @param unit unit of coordinates; if present, it overrides that of the file
 * @param usualUnit unit of coordinates in files that have none
 * @param projection projection of degrees to metres
 * @param frame scale and position of drawings without a unit; empty if they are not known
 * @param choice the parts of the drawing that are walls
 */
public record DrawingSettings(
    Optional<Unit> unit,
    Unit usualUnit,
    LocalProjection projection,
    Optional<PictureFrame> frame,
    LayerChoice choice) {
  /** The points of a file whose coordinates have a unit. */
  PlanPoints points() {
    return new PlanPoints(unit.orElse(usualUnit), projection);
  }
}
