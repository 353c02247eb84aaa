package org.hificamsim.presentation.replay;

import org.hificamsim.core.detection.ZoomLevel;

/**
 * How a camera with optics sees at one zoom level.
 *
 * @param viewingAngle full opening angle, radians, (0, 2 pi]
 * @param density pixels per metre at a distance of one metre; 0 where the scenario names no pixels
 *     or no lens
 */
public record LevelOptics(double viewingAngle, double density) {
  /** Of a zoom level: W / (2 tan(theta / 2)), W pixels across an angle of view theta. */
  static LevelOptics of(ZoomLevel zoom) {
    boolean known = zoom.pixels() > 0 && zoom.angleOfView() < Math.PI;
    double across = known ? 2 * StrictMath.tan(zoom.angleOfView() / 2) : 1;
    return new LevelOptics(zoom.viewingAngle(), known ? zoom.pixels() / across : 0);
  }
}
