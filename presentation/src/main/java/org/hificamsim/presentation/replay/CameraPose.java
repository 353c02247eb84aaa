package org.hificamsim.presentation.replay;

import java.util.List;
import org.hificamsim.core.detection.ZoomLevel;

/**
 * Where a camera stands, where it looks and how far.
 *
 * @param x metres
 * @param y metres
 * @param heading radians, 0 is +y and pi/2 is +x; not normalised
 * @param viewingAngle full opening angle, radians, (0, 2 pi]; of the narrowest level where they
 *     differ
 * @param levels its zoom levels, the narrowest first
 * @param pans its pan angles, radians off the heading, to the right; empty where it cannot turn
 * @param tilts its tilt at each pan angle, radians below the horizon; empty where it has one
 * @param lenses by level, where the levels differ in angle or have a pixel density
 * @param visible corners of the region that solid obstacles leave in sight, x and y in turn,
 *     metres; empty where the scenario has none
 * @param grounds by tilt and level: the corners of what its picture has of the ground, metres to
 *     the right of its view and ahead in turn; empty in a flat world
 */
public record CameraPose(
    double x,
    double y,
    double heading,
    double viewingAngle,
    List<Level> levels,
    @IfAny List<Double> pans,
    @IfAny List<Double> tilts,
    @IfAny List<LevelOptics> lenses,
    @IfAny List<Double> visible,
    @IfAny List<List<Double>> grounds) {
  /**
   * A zoom level of a camera.
   *
   * @param radius of the field of view, metres
   * @param detected the distances at which a target of the usual size is detected, ascending
   */
  public record Level(double radius, List<Interval> detected) {}

  /** A closed range of distances, metres. */
  public record Interval(double from, double to) {}

  /**
   * How a camera with optics sees at one zoom level.
   *
   * @param viewingAngle full opening angle, radians, (0, 2 pi]
   * @param density pixels per metre at a distance of one metre; 0 where the scenario names no
   *     pixels or no lens
   */
  public record LevelOptics(double viewingAngle, double density) {
    /** Of a zoom level: W / (2 tan(theta / 2)), W pixels across an angle of view theta. */
    static LevelOptics of(ZoomLevel zoom) {
      boolean known = zoom.pixels() > 0 && zoom.angleOfView() < Math.PI;
      double across = known ? 2 * StrictMath.tan(zoom.angleOfView() / 2) : 1;
      return new LevelOptics(zoom.viewingAngle(), known ? zoom.pixels() / across : 0);
    }
  }

  /** Whether its lists fit each other, as a file may say otherwise. */
  boolean consistent() {
    return !levels.isEmpty()
        && (lenses.isEmpty() || lenses.size() == levels.size())
        && visible.size() % 2 == 0;
  }

  /** How many views it can choose: each level at each pan angle. */
  public int views() {
    return levels.size() * Math.max(1, pans.size());
  }

  /** Whether its pixels per metre are known. */
  public boolean hasDensity() {
    return !lenses.isEmpty() && lenses.get(0).density() > 0;
  }
}
