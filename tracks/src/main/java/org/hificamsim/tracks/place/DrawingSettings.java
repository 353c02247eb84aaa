package org.hificamsim.tracks.place;

import java.util.Optional;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.LocalProjection;

/**
 * How a drawing or map is read.
 *
 * @param unit of coordinates; if present, it overrides that of the file
 * @param usualUnit of coordinates in files that have none
 * @param projection of degrees
 * @param frame of drawings without a unit; empty if their scale is not known
 * @param choice of what is a wall
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
