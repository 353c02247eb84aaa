package org.hificamsim.core.detection;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * A detection model with the threshold it is used with. Any number of runs and threads may share
 * one: what it has found out about a zoom level is remembered for all of them.
 */
public final class Detection {
  private final String name;
  private final DetectionModel model;
  private final double threshold;
  private final Map<Pair, DetectedDistances> found = new ConcurrentHashMap<>();

  /** Of a model and a threshold, under the model's name. */
  public Detection(DetectionModel model, double threshold) {
    this(model.name(), model, threshold);
  }

  /**
   * Of a model and a threshold.
   *
   * @param name in result files, where it tells one model with two thresholds apart
   * @param threshold a target inside the field of view is detected when the model's value is at
   *     least this
   */
  public Detection(String name, DetectionModel model, double threshold) {
    this.name = name;
    this.model = model;
    this.threshold = threshold;
  }

  /** The model with its own default threshold. */
  public static Detection of(DetectionModel model) {
    return new Detection(model, model.defaultThreshold());
  }

  /** The name in result files. */
  public String name() {
    return name;
  }

  /** The detection model. */
  public DetectionModel model() {
    return model;
  }

  /** The least value of the model at which a target counts as detected. */
  public double threshold() {
    return threshold;
  }

  /** The distances detected at a zoom level; the model must not depend on the bearing. */
  public DetectedDistances distances(double size, ZoomLevel zoom) {
    return found.computeIfAbsent(
        new Pair(size, zoom), pair -> DetectedDistances.of(model, size, zoom, threshold));
  }

  private record Pair(double size, ZoomLevel zoom) {}
}
