package org.hificamsim.core.detection;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Computes how confident a camera is that it detects a target: an extension point, found by {@link
 * #name}.
 *
 * <p>An implementer writes {@link #name} and {@link #confidence}, and overrides the other methods
 * if the default threshold is not one half, the model depends on the bearing, or its values are not
 * proportions. Detected distances, field of view and threshold rule come free. Models hold no
 * state: one instance serves any number of threads.
 */
public interface DetectionModel {
  /** The name on the command line and in result files. */
  String name();

  /**
   * Computes the model's value for a target inside the field of view; it is never called for
   * others. A {@link DetectionRule} decides whether a value is detected; NaN never is.
   *
   * @param size target size q, in metres, above 0
   * @param distance camera-target distance d, in metres, 0 or more
   * @param offAxis angle between heading and target, in radians, [0, pi]; NaN if the target stands
   *     on the camera or rounding leaves no angle
   * @param zoom the camera's zoom level
   * @return the value of the formula, not clamped; see {@link #reported}
   */
  double confidence(double size, double distance, double offAxis, ZoomLevel zoom);

  /**
   * Computes the value like {@link #confidence(double, double, double, ZoomLevel)}, for a target
   * that is partly hidden; called only if {@link #dependsOnHiddenShare}.
   *
   * @param hiddenShare the share of the target's silhouette that solid obstacles and nearer targets
   *     hide, in [0, 1]
   */
  default double confidence(
      double size, double distance, double offAxis, ZoomLevel zoom, double hiddenShare) {
    return confidence(size, distance, offAxis, zoom);
  }

  /**
   * Whether {@link #confidence} depends on the share of a target that is hidden. Solid obstacles
   * and nearer targets, regardless of the scenario's occlusion, then hide targets by degrees; one
   * that is hidden entirely is never detected.
   */
  default boolean dependsOnHiddenShare() {
    return false;
  }

  /**
   * Whether the size that {@link #confidence} takes is the target's height, as it appears in the
   * picture, instead of the edge of its bounding box.
   */
  default boolean byHeight() {
    return false;
  }

  /** The threshold that is used if neither the settings nor the scenario give one. */
  default double defaultThreshold() {
    return 0.5;
  }

  /**
   * Whether {@link #confidence} depends on {@code offAxis}; such a model is evaluated for each
   * target in view.
   */
  default boolean dependsOnBearing() {
    return false;
  }

  /**
   * Whether {@link #confidence} depends on {@code offAxis} at one zoom level, for angles between 0
   * and pi. A model that depends on the bearing only at some levels saves the arc cosine at the
   * others.
   */
  default boolean dependsOnBearing(ZoomLevel zoom) {
    return dependsOnBearing();
  }

  /**
   * The confidence, 0 or more, that a camera reports to others for a value that reaches the
   * threshold; in [0, 1] unless the model's values are not proportions.
   */
  default double reported(double value) {
    return clamp(value);
  }

  /**
   * Whether distances are measured over the ground even if cameras have heights, as CamSim's rules
   * do, whose world is flat. Other models are given the distance in space.
   */
  default boolean flat() {
    return false;
  }

  /** The part of a target that must be seen if the scenario does not give it. */
  default Seen seen() {
    return Seen.WHOLE;
  }

  /**
   * The scatter of measured confidences about the model's values, if known; {@link
   * DetectionRule.Chance} draws from it.
   */
  default Optional<Scatter> scatter() {
    return Optional.empty();
  }

  /** The rule that is used if neither the settings nor the scenario give a rule or threshold. */
  default DetectionRule defaultRule() {
    return new DetectionRule.Threshold();
  }

  /**
   * The mean number of detections in a step that show no target, if it is known; cameras report
   * them as phantoms if the rule says so.
   */
  default OptionalDouble phantoms() {
    return OptionalDouble.empty();
  }

  /** Clamps a value to [0, 1]; NaN becomes 0. */
  static double clamp(double value) {
    return value >= 1 ? 1 : value > 0 ? value : 0;
  }
}
