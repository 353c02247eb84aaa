package org.hificamsim.core.policy;

import org.hificamsim.core.channel.Channel;
import org.hificamsim.core.channel.Stations;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.metrics.CoveredTargets;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.visibility.Body;

/**
 * The read-only knowledge of a deployed camera network in one step, from which {@linkplain
 * ZoomPolicy policies} decide. All cameras decide from the same snapshot.
 *
 * <p>It has what the cameras detected at the last observation (nothing before the first one), and
 * what their installer knows: the map of the site, how long moves take, and what a lens and a
 * detection model make of a position. It gives no access to the positions of targets, nor to what a
 * camera would detect at another view: see {@link OracleView}.
 *
 * <p>While a policy decides, {@link #detected} and {@link #coverage} are still those of the last
 * observation, whereas {@link #sees}, {@link #findSeen}, {@link #distance}, {@link #bearing} and
 * {@link #confidence} look again, through the present views at the present positions of targets.
 *
 * <p>Cameras and targets are numbered from 0 and keep their numbers for the whole run. The counts
 * include those that a later event adds; until then, and after an event removes them, these are not
 * online (cameras) or not present (targets).
 *
 * <p>A camera's views are each of its zoom levels at each of its pan angles: all levels of the
 * first angle, from the narrowest, then those of the next angle. A camera that cannot turn has its
 * levels only. A camera that tilts has each pan angle once for each of its tilts; the tilt is in
 * the view's {@linkplain ZoomLevel#vertical zoom level}.
 */
public interface NetworkView extends CoveredTargets, Stations {
  /** The objective that scores each step of the run. */
  default Objective objective() {
    return Objective.kMin();
  }

  /** The name in the scenario file. */
  String cameraName(int camera);

  /** The heading of a camera, in radians: 0 is +y and pi/2 is +x; not normalised. */
  double cameraHeading(int camera);

  /** The number of views of this camera, 1 or more. */
  int views(int camera);

  /** The number of the camera's zoom levels, 1 or more. */
  default int zooms(int camera) {
    return views(camera);
  }

  /** The number of the camera's pan angles, 1 or more. */
  default int pans(int camera) {
    return views(camera) / zooms(camera);
  }

  /** The number of a view's zoom level, 0 the narrowest. */
  default int zoomOf(int camera, int view) {
    return view % zooms(camera);
  }

  /** The number of a view's pan angle, 0 the first. */
  default int panOf(int camera, int view) {
    return view / zooms(camera);
  }

  /** The view with these numbers of a pan angle and a zoom level. */
  default int viewAt(int camera, int pan, int zoom) {
    return pan * zooms(camera) + zoom;
  }

  /** The view that the camera chose last. */
  int view(int camera);

  /**
   * The view through which the camera sees: the one it chose unless it is still on its way, see
   * {@link org.hificamsim.core.scenario.spec.Moving}; -1 while it sees nothing.
   */
  default int seeing(int camera) {
    return view(camera);
  }

  /** Whether the camera is on its way to the view that it chose last. */
  default boolean moving(int camera) {
    return seeing(camera) != view(camera);
  }

  /**
   * Whether the camera could be in a view by the end of this step; where moves take no time,
   * whether the view is at most one level and one pan angle away.
   */
  default boolean reaches(int camera, int view) {
    return Math.abs(view - view(camera)) <= 1;
  }

  /**
   * Returns the number of steps that a camera needs before it sees through a view, if its move
   * begins now; 0 if it sees in the present step.
   */
  default int stepsTo(int camera, int view) {
    return 0;
  }

  /** Does the same as {@link #stepsTo} for a camera that would rest in the view {@code from}. */
  default int stepsBetween(int camera, int from, int view) {
    return 0;
  }

  /** Whether the camera sees nothing while it is on its way. */
  default boolean movesBlindly(int camera) {
    return true;
  }

  /**
   * Returns the angle by which the camera can turn within a step, in radians; infinite if it turns
   * at once.
   */
  default double turnInStep(int camera) {
    return Double.POSITIVE_INFINITY;
  }

  /**
   * Returns by how many zoom levels the camera's lens can change within a step; infinite if it
   * changes at once.
   */
  default double zoomInStep(int camera) {
    return Double.POSITIVE_INFINITY;
  }

  /** The zoom level of one of the camera's views. */
  ZoomLevel zoom(int camera, int view);

  /**
   * The distance beyond which the camera detects nothing in one of its views, in metres, as far as
   * it can be known: what the detection model reaches, at most the view's radius.
   */
  default double reach(int camera, int view) {
    return zoom(camera, view).radius();
  }

  /** The pan angle of one of the camera's views: radians off its heading, to the right. */
  default double pan(int camera, int view) {
    return 0;
  }

  /** The map: what blocks or dims lines of sight, as far as the installer of the cameras knows. */
  default Obstacles obstacles() {
    return Obstacles.NONE;
  }

  /**
   * The mean width of targets that hide each other, in metres; 0 if targets hide nothing. The
   * installer of the cameras knows it, like the sizes of targets.
   */
  default double hidingWidth() {
    return 0;
  }

  /**
   * The part of a target that cameras have to see where they have heights.
   *
   * @param size the size of the target, in metres; the nearest of those that the scenario has
   *     counts
   */
  default Body body(double size) {
    return Body.flat(size);
  }

  /** The rectangle that targets move in, which is known. */
  Field field();

  /**
   * Computes the chance that the camera would detect a target at a position, through each of its
   * views: by its lens and its detection model, which are known, wherever targets are.
   *
   * @param size the size of the target, in metres; the nearest of the sizes that the scenario has
   *     is taken
   * @param transmittance the part of the light that obstacles let through, in [0, 1]
   * @param chances receives one entry for each view, in [0, 1]
   * @return whether any chance is above 0; if not, the entries are undefined
   */
  boolean chancesAt(
      int camera, double x, double y, double size, double transmittance, double[] chances);

  /** The number of targets that the camera detected at the last observation; 0 while offline. */
  int detected(int camera);

  /** The name in result files: the features value, as CamSim prints it. */
  String targetName(int target);

  /**
   * The detection model's confidence for the target where both are now, through the view that the
   * camera sees through, in [0, 1]; 0 outside the field of view, or when the target is not present.
   */
  double confidence(int camera, int target);

  /**
   * The {@link #confidence} for a target that the camera {@link #sees}, which is not tested; to
   * about 1e-8, since it may come from a table.
   *
   * @param distance the distance between the two as {@link #findSeen} has found it, in metres
   */
  default double seenConfidence(int camera, int target, double distance) {
    return confidence(camera, target);
  }

  /**
   * Whether the camera detects a target, where both are now, through the view that it sees through;
   * false while it is offline or on its way, or the target is absent.
   */
  boolean sees(int camera, int target);

  /** Returns the edge of the bounding box of a target, in metres; NaN if it is not known. */
  default double targetSize(int target) {
    return Double.NaN;
  }

  /**
   * The distance of a target that the camera {@link #sees}, in metres; NaN for any other target.
   */
  double distance(int camera, int target);

  /**
   * Returns the bearing at which the camera {@link #sees} a target: radians to the right of the
   * view's axis, in [-pi, pi]; NaN for a target that it does not see.
   */
  double bearing(int camera, int target);

  /**
   * Finds all targets that cameras {@link #sees see}, with their positions relative to the cameras:
   * the same as a query for each pair, but much faster.
   *
   * @param pairs receives these pairs, in the order of cameras; what it held before is cleared
   */
  void findSeen(SeenPairs pairs);

  /** The channel of all messages between cameras; perfect unless the run has another. */
  default Channel channel() {
    return Channel.PERFECT;
  }
}
