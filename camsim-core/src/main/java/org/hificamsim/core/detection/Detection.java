package org.hificamsim.core.detection;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.DoubleUnaryOperator;
import org.hificamsim.core.InputException;

/**
 * A detection model with the rule and the threshold it is used with. Any number of runs and threads
 * may share one: what it has found out about a zoom level is remembered for all of them.
 */
public final class Detection {
  private static final double HALF = 0.5;

  private final String name;
  private final DetectionModel model;
  private final DetectionRule rule;
  private final boolean certain;
  private final double threshold;
  private final DoubleUnaryOperator chance;
  private final Map<Pair, DetectedDistances> found = new ConcurrentHashMap<>();
  private final Map<Pair, ChanceTable> tables = new ConcurrentHashMap<>();
  private final Map<Pair, DistanceTable> values = new ConcurrentHashMap<>();
  private final Map<InSpace, Detection> inSpace = new ConcurrentHashMap<>();

  private Detection(
      String name,
      DetectionModel model,
      DetectionRule rule,
      double threshold,
      DoubleUnaryOperator chance) {
    this.name = name;
    this.model = model;
    this.rule = rule;
    this.certain = rule.certain();
    this.threshold = threshold;
    this.chance = chance;
  }

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
    this(
        name, model, new DetectionRule.Threshold(), threshold, value -> value >= threshold ? 1 : 0);
  }

  /** The model with its own default threshold. */
  public static Detection of(DetectionModel model) {
    return new Detection(model, model.defaultThreshold());
  }

  /**
   * Of a model and a rule; by a threshold it is the model's default.
   *
   * @param name in result files
   * @throws InputException when the rule needs a scatter, and the model has none
   */
  public static Detection by(DetectionRule rule, String name, DetectionModel model) {
    if (rule instanceof DetectionRule.Chance chance) {
      Scatter scatter = model.scatter().orElseThrow(() -> noScatter(model));
      double threshold = scatter.threshold(chance.alpha());
      return new Detection(
          name, model, rule, scatter.half(threshold), value -> scatter.chance(value, threshold));
    }
    return rule instanceof DetectionRule.Probability
        ? new Detection(name, model, rule, HALF, DetectionModel::clamp)
        : new Detection(name, model, model.defaultThreshold());
  }

  private static InputException noScatter(DetectionModel model) {
    return InputException.of(
        "detection '%s' has no rmse, from which detect=chance draws: expected a model"
            + " that has one, detect=probability or detect=threshold",
        model.name());
  }

  /**
   * The same where a camera looks from above or below, asked by distances over the ground.
   *
   * @param rise from what has to be seen to the camera, metres
   * @param foreshortened whether what is seen from above looks shorter
   */
  public Detection inSpace(double rise, boolean foreshortened) {
    return model.flat()
        ? this
        : inSpace.computeIfAbsent(
            new InSpace(model, rise, foreshortened),
            its -> new Detection(name, its, rule, threshold, chance));
  }

  /** The name in result files. */
  public String name() {
    return name;
  }

  /** The detection model. */
  public DetectionModel model() {
    return model;
  }

  /** How a value becomes a detection. */
  public DetectionRule rule() {
    return rule;
  }

  /** Whether equal values are equally detected: no luck is drawn. */
  public boolean certain() {
    return certain;
  }

  /** The least value that is detected; by chance, the one that is detected half of the time. */
  public double threshold() {
    return threshold;
  }

  /** The chance that a target with this value is detected, in [0, 1]; 1 or 0 by a threshold. */
  public double chance(double value) {
    return chance.applyAsDouble(value);
  }

  /**
   * Whether a target with this value is detected; one whose value is NaN never is. Where something
   * is in between, a threshold takes as much of the value as gets through, chance as much of the
   * chance.
   *
   * @param luck in [0, 1), drawn for the pair of camera and target; without effect by a threshold
   * @param transmittance how much gets through, in [0, 1]
   */
  public boolean detects(double value, double luck, double transmittance) {
    return certain
        ? transmittance > 0 && value * transmittance >= threshold
        : luck < transmittance * chance(value);
  }

  /** The distances detected at a zoom level; the model must not depend on the bearing. */
  public DetectedDistances distances(double size, ZoomLevel zoom) {
    return found.computeIfAbsent(
        new Pair(size, zoom), pair -> DetectedDistances.of(model, size, zoom, threshold));
  }

  /** The chances at a zoom level by distance; the model must not depend on the bearing. */
  public ChanceTable chances(double size, ZoomLevel zoom) {
    return tables.computeIfAbsent(new Pair(size, zoom), pair -> new ChanceTable(this, size, zoom));
  }

  /** The model's values at a zoom level by distance; it must not depend on the bearing. */
  public DistanceTable values(double size, ZoomLevel zoom) {
    return values.computeIfAbsent(
        new Pair(size, zoom),
        pair ->
            DistanceTable.of(zoom.radius(), distance -> model.confidence(size, distance, 0, zoom)));
  }

  private record Pair(double size, ZoomLevel zoom) {}
}
