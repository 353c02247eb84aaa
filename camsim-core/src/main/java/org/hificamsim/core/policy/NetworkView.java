package org.hificamsim.core.policy;

import org.hificamsim.core.detection.ZoomLevel;

/**
 * The camera network at one step, read only: the same for every camera, so that all decide from one
 * snapshot.
 *
 * <p>Cameras and targets are numbered from 0 and keep their number for the whole run; the counts
 * include those that a later event adds, which are not online (not present) until then, and stay so
 * after an event removes them. Zoom levels are numbered from 0, the narrowest. What was detected is
 * what the last observation saw: at a decision that is the step before (0 everywhere at the first).
 *
 * <p>{@link #detects}, {@link #dominates} and the target positions are knowledge that no camera has
 * on its own: upper bounds such as the exact optimum use them, learning policies must not.
 */
public interface NetworkView {
  /** The step that is under way, from 0. */
  long step();

  /** A number that changes whenever a camera is added, moved or switched off. */
  int revision();

  int cameras();

  String cameraName(int camera);

  /** Whether the camera takes part: it has been added, and no event has switched it off. */
  boolean online(int camera);

  double cameraX(int camera);

  double cameraY(int camera);

  /** Radians, 0 is +y and pi/2 is +x; not normalised. */
  double cameraHeading(int camera);

  /** The number of zoom levels of this camera, 1 or more. */
  int levels(int camera);

  /** The camera's current level. */
  int level(int camera);

  ZoomLevel zoom(int camera, int level);

  /** How many targets the camera detected at the last observation; 0 while offline. */
  int detected(int camera);

  int targets();

  String targetName(int target);

  boolean present(int target);

  double targetX(int target);

  double targetY(int target);

  /** How many cameras detected the target at the last observation: k_j of section 7.1. */
  int coverage(int target);

  /**
   * The detection model's confidence for the target where both are now, at the camera's current
   * level, in [0, 1]; 0 outside the field of view, or when the target is not present.
   */
  double confidence(int camera, int target);

  /** Whether the camera would detect the target where both are now, were it at this level. */
  boolean detects(int camera, int level, int target);

  /**
   * Whether {@code level} is proven to detect everything that {@code other} does, wherever the
   * targets stand; false where that is not known.
   */
  boolean dominates(int camera, int level, int other);
}
