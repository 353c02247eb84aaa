package org.hificamsim.core.detection;

import java.util.Optional;

/**
 * How confident a camera is that it detects a target: an extension point, found by {@link #name}.
 *
 * <p>An implementer writes {@link #name} and {@link #confidence}; a model whose default threshold
 * is not one half, that looks at the bearing, or whose values are no proportions, says so. The
 * detected distances per zoom level, the field of view and the threshold rule come free. Models
 * hold no state: one instance serves any number of threads.
 */
public interface DetectionModel {
  /** The name on the command line and in result files. */
  String name();

  /**
   * The model's value for a target inside the field of view; targets outside it are never asked
   * for. A {@link DetectionRule} says whether a value is detected; NaN never is.
   *
   * @param size target size q, metres, above 0
   * @param distance camera-target distance d, metres, 0 or more
   * @param offAxis angle between heading and target, radians, [0, pi]; NaN where the target stands
   *     on the camera or rounding leaves no angle
   * @param zoom the camera's zoom level
   * @return the value as the formula gives it, not clamped; see {@link #reported}
   */
  double confidence(double size, double distance, double offAxis, ZoomLevel zoom);

  /** The threshold used where neither the command line nor the scenario gives one. */
  default double defaultThreshold() {
    return 0.5;
  }

  /**
   * Whether {@link #confidence} depends on {@code offAxis}; such a model is asked for each target
   * in view.
   */
  default boolean dependsOnBearing() {
    return false;
  }

  /**
   * The same at one zoom level, for angles between 0 and pi; a model that depends on the bearing at
   * some levels alone says so, and spares the arc cosine at the others.
   */
  default boolean dependsOnBearing(ZoomLevel zoom) {
    return dependsOnBearing();
  }

  /**
   * The confidence that a camera reports to others for a value that reaches the threshold, 0 or
   * more; in [0, 1] but for models whose values are no proportions.
   */
  default double reported(double value) {
    return clamp(value);
  }

  /**
   * Whether distances are measured over the ground, also where cameras have a height: the rules of
   * CamSim, whose world is flat. All others get the distance in space.
   */
  default boolean flat() {
    return false;
  }

  /** What of a target has to be seen where the scenario does not say. */
  default Seen seen() {
    return Seen.WHOLE;
  }

  /**
   * How confidences that were measured scatter about the model's values, where that is known: what
   * {@link DetectionRule.Chance} draws from.
   */
  default Optional<Scatter> scatter() {
    return Optional.empty();
  }

  /** A value as a proportion in [0, 1]; NaN counts as 0. */
  static double clamp(double value) {
    return value >= 1 ? 1 : value > 0 ? value : 0;
  }
}
