package org.hificamsim.presentation.replay;

import java.util.List;
import org.hificamsim.core.detection.ZoomLevel;

/**
 * The position, heading and views of a camera.
 *
 * @param x the x coordinate in metres
 * @param y the y coordinate in metres
 * @param heading the heading in radians, 0 is +y and pi/2 is +x; not normalised
 * @param viewingAngle the full opening angle, in radians, (0, 2 pi]; that of the narrowest level if
 *     the levels differ
 * @param levels the zoom levels, the narrowest first
 * @param pans the pan angle of each direction, of which there is one for each pan angle at each
 *     tilt: radians from the heading to the right; empty if the camera cannot turn
 * @param tilts the tilt of each direction, in radians below the horizon; empty if all are the same
 * @param lenses for each level, its optics; empty unless the levels differ in angle or have a pixel
 *     density
 * @param visible the corners of the region that no solid obstacle hides, x and y in turn, in
 *     metres; empty if the scenario has no solid obstacles
 * @param grounds for each tilt and level, the corners of the ground that is in the picture, metres
 *     to the right of the view and ahead in turn; empty in a flat world
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
   * @param radius the radius of the field of view, in metres
   * @param detected the distances at which a target of the usual size is detected, ascending
   */
  public record Level(double radius, List<Interval> detected) {}

  /** A closed range of distances, in metres. */
  public record Interval(double from, double to) {}

  /**
   * The optics of a camera at one zoom level.
   *
   * @param viewingAngle full opening angle, in radians, (0, 2 pi]
   * @param density pixels per metre at a distance of one metre; 0 if the scenario names no pixels
   *     or no lens
   */
  public record LevelOptics(double viewingAngle, double density) {
    /**
     * Returns the optics of a level. The density is W / (2 tan(theta / 2)) for W pixels across an
     * angle of view theta.
     */
    static LevelOptics of(ZoomLevel zoom) {
      boolean known = zoom.pixels() > 0 && zoom.angleOfView() < Math.PI;
      double across = known ? 2 * StrictMath.tan(zoom.angleOfView() / 2) : 1;
      return new LevelOptics(zoom.viewingAngle(), known ? zoom.pixels() / across : 0);
    }
  }

  /** Whether the lengths of the lists fit each other, which may be wrong in a file. */
  boolean isConsistent() {
    return !levels.isEmpty()
        && (lenses.isEmpty() || lenses.size() == levels.size())
        && visible.size() % 2 == 0;
  }

  /** The number of views that the camera can choose: each level at each pan angle. */
  public int views() {
    return levels.size() * Math.max(1, pans.size());
  }

  /** Whether the pixels per metre of the camera are known. */
  public boolean hasDensity() {
    return !lenses.isEmpty() && lenses.get(0).density() > 0;
  }
}
