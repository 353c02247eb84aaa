package org.hificamsim.core.detection;

/**
 * A detection model with the threshold it is used with.
 *
 * @param threshold a target inside the field of view is detected when the model's value is at least
 *     this
 */
public record Detection(DetectionModel model, double threshold) {
  /** The model with its own default threshold. */
  public static Detection of(DetectionModel model) {
    return new Detection(model, model.defaultThreshold());
  }

  /** The distances detected at a zoom level; the model must not depend on the bearing. */
  public DetectedDistances distances(double size, ZoomLevel zoom) {
    return DetectedDistances.of(model, size, zoom, threshold);
  }
}
