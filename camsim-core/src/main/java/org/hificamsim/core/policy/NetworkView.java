package org.hificamsim.core.policy;

import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.metrics.CoveredTargets;
import org.hificamsim.core.metrics.Objective;

/**
 * The camera network at one step, read only: the same for every camera, so that all decide from one
 * snapshot.
 *
 * <p>Cameras and targets are numbered from 0 and keep their number for the whole run; the counts
 * include those that a later event adds, which are not online (not present) until then, and stay so
 * after an event removes them. Zoom views are numbered from 0, the narrowest. What was detected is
 * what the last observation saw: at a decision that is the step before (0 everywhere at the first).
 *
 * <p>This is what cameras know between them. Positions of targets, and what a camera would detect
 * at another view, are in {@link OracleView}.
 */
public interface NetworkView extends CoveredTargets {
  /** The step that is under way, from 0. */
  long step();

  /** What each step of the run is scored by. */
  default Objective objective() {
    return Objective.kMin();
  }

  /** A number that changes whenever a camera is added, moved or switched off. */
  int revision();

  /** How many cameras there will ever be. */
  int cameras();

  /** The name in the scenario file. */
  String cameraName(int camera);

  /** Whether the camera takes part: it has been added, and no event has switched it off. */
  boolean online(int camera);

  /** Metres. */
  double cameraX(int camera);

  /** Metres. */
  double cameraY(int camera);

  /** Radians, 0 is +y and pi/2 is +x; not normalised. */
  double cameraHeading(int camera);

  /** The number of zoom views of this camera, 1 or more. */
  int views(int camera);

  /** The camera's current view. */
  int view(int camera);

  /** One of the camera's zoom views. */
  ZoomLevel zoom(int camera, int view);

  /** How many targets the camera detected at the last observation; 0 while offline. */
  int detected(int camera);

  /**
   * Whether the camera detects the target where both are now, at its current view: what it knows of
   * itself.
   */
  default boolean detects(int camera, int target) {
    return online(camera) && oracle().detects(camera, view(camera), target);
  }

  /** The name in result files: the features value, as CamSim prints it. */
  String targetName(int target);

  /**
   * The detection model's confidence for the target where both are now, at the camera's current
   * view, in [0, 1]; 0 outside the field of view, or when the target is not present.
   */
  double confidence(int camera, int target);

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
