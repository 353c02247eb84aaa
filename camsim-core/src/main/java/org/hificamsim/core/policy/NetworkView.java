package org.hificamsim.core.policy;

import java.util.DoubleSummaryStatistics;
import java.util.stream.IntStream;
import org.hificamsim.core.channel.Channel;
import org.hificamsim.core.channel.Stations;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.metrics.CoveredTargets;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.visibility.Body;

/**
 * The camera network at one step, read only: the same for every camera, so that all decide from one
 * snapshot.
 *
 * <p>Cameras and targets are numbered from 0 and keep their number for the whole run; the counts
 * include those that a later event adds, which are not online (not present) until then, and stay so
 * after an event removes them. A camera's views are each of its zoom levels at each of its pan
 * angles: all levels of the first angle, from the narrowest, then those of the next; a camera that
 * cannot turn has its levels alone. One that tilts has each pan angle at each of its tilts, as if
 * it were another angle; a view's tilt is in its {@linkplain ZoomLevel#vertical zoom level}. What
 * was detected is what the last observation saw: at a decision that is the step before (0
 * everywhere at the first).
 *
 * <p>This is what cameras know between them, with what their installer knows: the map of the site,
 * how long moves take, and what a lens and a detection model make of a place. Positions of targets,
 * and what a camera would detect of them at another view, are in {@link OracleView}.
 */
public interface NetworkView extends CoveredTargets, Stations {
  /** What each step of the run is scored by. */
  default Objective objective() {
    return Objective.kMin();
  }

  /** The name in the scenario file. */
  String cameraName(int camera);

  /** Radians, 0 is +y and pi/2 is +x; not normalised. */
  double cameraHeading(int camera);

  /** The number of views of this camera, 1 or more. */
  int views(int camera);

  /** The number of its zoom levels, 1 or more. */
  default int zooms(int camera) {
    return views(camera);
  }

  /** The number of its pan angles, 1 or more. */
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
   * How many steps the camera is on its way before the first one that it sees through a view, if it
   * sets out now: 0 where it does so in the step that is under way.
   */
  default int stepsTo(int camera, int view) {
    return 0;
  }

  /** How far the camera turns within a step, radians; infinite where it turns at once. */
  default double turnInStep(int camera) {
    return Double.POSITIVE_INFINITY;
  }

  /** How far its lens changes within a step, zoom levels; infinite where it changes at once. */
  default double zoomInStep(int camera) {
    return Double.POSITIVE_INFINITY;
  }

  /** The zoom level of one of the camera's views. */
  ZoomLevel zoom(int camera, int view);

  /**
   * The distance beyond which the camera detects nothing in one of its views, metres, as far as it
   * can be known: what the detection model reaches, at most the view's radius.
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
   * What cameras have to see of a target where they have heights.
   *
   * @param size of the target, metres; the nearest of those that the scenario has counts
   */
  default Body body(double size) {
    return Body.flat(size);
  }

  /** The rectangle that targets move in, also known; by default one that holds all cameras. */
  default Field field() {
    DoubleSummaryStatistics x =
        IntStream.range(0, cameras()).mapToDouble(this::cameraX).summaryStatistics();
    DoubleSummaryStatistics y =
        IntStream.range(0, cameras()).mapToDouble(this::cameraY).summaryStatistics();
    return cameras() == 0
        ? new Field(0, 0, 0, 0)
        : new Field(x.getMin(), x.getMax(), y.getMin(), y.getMax());
  }

  /**
   * How likely the camera would detect a target that stood at a place, through each of its views:
   * by its lens and its detection model, which are known, wherever targets are.
   *
   * @param size of the target, metres; the nearest of those that the scenario has counts
   * @param transmittance how much of it gets through what is in between, in [0, 1]
   * @param chances one entry for each view, in [0, 1]
   * @return whether any is above 0; if not, the entries mean nothing
   */
  default boolean chancesAt(
      int camera, double x, double y, double size, double transmittance, double[] chances) {
    double dx = x - cameraX(camera);
    double dy = y - cameraY(camera);
    double distance = Math.hypot(dx, dy);
    boolean any = false;
    for (int view = 0; view < views(camera); view++) {
      double axis = cameraHeading(camera) + pan(camera, view);
      double off = Math.abs(Math.IEEEremainder(Math.atan2(dx, dy) - axis, 2 * Math.PI));
      boolean inView =
          distance <= reach(camera, view) && off <= zoom(camera, view).viewingAngle() / 2;
      chances[view] = inView ? transmittance : 0;
      any |= inView;
    }
    return any;
  }

  /** How many targets the camera detected at the last observation; 0 while offline. */
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
   * @param distance between the two as {@link #findSeen} has found it, metres
   */
  default double seenConfidence(int camera, int target, double distance) {
    return confidence(camera, target);
  }

  /** Whether the camera detects a target where both are now; as observed when asked in learn. */
  default boolean sees(int camera, int target) {
    int view = seeing(camera);
    return online(camera) && view >= 0 && present(target) && oracle().detects(camera, view, target);
  }

  /** Edge of the bounding box of a target, metres; NaN where that is not known. */
  default double targetSize(int target) {
    return Double.NaN;
  }

  /** How far a target is that the camera {@link #sees}, metres; NaN for one that it does not. */
  default double distance(int camera, int target) {
    return sees(camera, target)
        ? Math.hypot(
            oracle().targetX(target) - cameraX(camera), oracle().targetY(target) - cameraY(camera))
        : Double.NaN;
  }

  /**
   * Where in its picture the camera {@link #sees} a target: radians off the view's axis, to the
   * right, in [-pi, pi]; NaN for one that it does not see.
   */
  default double bearing(int camera, int target) {
    if (!sees(camera, target)) {
      return Double.NaN;
    }
    double dx = oracle().targetX(target) - cameraX(camera);
    double dy = oracle().targetY(target) - cameraY(camera);
    double axis = cameraHeading(camera) + pan(camera, seeing(camera));
    return Math.IEEEremainder(Math.atan2(dx, dy) - axis, 2 * Math.PI);
  }

  /**
   * Finds all targets that cameras {@link #sees see}, and where before them they are: the same as
   * asking of each, but those out of reach cost nothing.
   *
   * @param pairs has these pairs on return, and no others
   */
  default void findSeen(SeenPairs pairs) {
    pairs.clear();
    for (int camera = 0; camera < cameras(); camera++) {
      for (int target = 0; target < targets(); target++) {
        if (sees(camera, target)) {
          double distance = distance(camera, target);
          double bearing = bearing(camera, target);
          pairs.add(camera, target, distance * Math.cos(bearing), distance * Math.sin(bearing));
        }
      }
    }
  }

  /** What all messages between cameras go over; perfect unless the run has another. */
  default Channel channel() {
    return Channel.PERFECT;
  }

  /** The same network with what no camera knows, for upper bounds and records; see there. */
  OracleView oracle();

  /**
   * Does a task for all cameras, in parts side by side where the run has several threads.
   *
   * <p>The task must come to the same result however the cameras are divided: what it writes of one
   * camera it must not read of another. All is done on return.
   */
  default <T> void divide(T work, CameraTask<T> task) {
    task.run(this, work, 0, cameras());
  }
}
