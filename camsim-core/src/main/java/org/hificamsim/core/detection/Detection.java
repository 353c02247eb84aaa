package org.hificamsim.core.detection;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.DoubleUnaryOperator;
import org.hificamsim.core.InputException;

/**
 * A detection model with its rule and threshold. Runs and threads may share one, together with its
 * cached tables.
 */
public final class Detection {
  private static final double HALF = 0.5;

  private static final DetectionModel IN_VIEW = new GeometricDetection();

  private final String name;
  private final DetectionModel model;
  private final DetectionRule rule;
  private final boolean certain;
  private final double threshold;
  private final DoubleUnaryOperator chance;
  private final Map<Double, Detection> byThreshold = new ConcurrentHashMap<>();
  private final Map<SizeAtZoom, DetectedDistances> distances = new ConcurrentHashMap<>();
  private final Map<SizeAtZoom, DetectedDistances> distancesInView = new ConcurrentHashMap<>();
  private final Map<SizeAtZoom, ChanceTable> chances = new ConcurrentHashMap<>();
  private final Map<SizeAtZoom, DistanceTable> values = new ConcurrentHashMap<>();
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

  /** Creates a detection by a threshold, under the model's name. */
  public Detection(DetectionModel model, double threshold) {
    this(model.name(), model, threshold);
  }

  /**
   * Creates a detection by a threshold.
   *
   * @param name the name in result files; distinguishes detections of one model with different
   *     thresholds
   * @param threshold the least value of the model at which a target inside the field of view is
   *     detected
   */
  public Detection(String name, DetectionModel model, double threshold) {
    this(
        name, model, new DetectionRule.Threshold(), threshold, value -> value >= threshold ? 1 : 0);
  }

  /** Creates a detection by the model's default threshold. */
  public static Detection of(DetectionModel model) {
    return new Detection(model, model.defaultThreshold());
  }

  /**
   * Creates a detection by a rule; the rule {@code threshold} takes the model's default threshold.
   *
   * @param name the name in result files
   * @throws InputException if the rule needs a scatter or a number of false alarms and the model
   *     has none
   */
  public static Detection by(DetectionRule rule, String name, DetectionModel model) {
    requirePhantoms(rule, model);
    if (rule instanceof DetectionRule.Chance chance && !isProbability(chance, model)) {
      Scatter scatter = model.scatter().orElseThrow(() -> noScatter(model));
      double threshold = scatter.threshold(chance.alpha());
      return new Detection(
          name, model, rule, scatter.half(threshold), value -> scatter.chance(value, threshold));
    }
    return rule.certain()
        ? new Detection(name, model, model.defaultThreshold())
        : new Detection(name, model, rule, HALF, DetectionModel::clamp);
  }

  /** Whether the values of a model are probabilities, from which chance draws without a scatter. */
  private static boolean isProbability(DetectionRule.Chance chance, DetectionModel model) {
    return model.scatter().isEmpty()
        && model.defaultRule() instanceof DetectionRule.Probability
        && chance.alpha() == DetectionRule.Chance.DEFAULT_ALPHA;
  }

  private static void requirePhantoms(DetectionRule rule, DetectionModel model) {
    if (rule instanceof DetectionRule.Probability
        && rule.phantoms() > 0
        && model.phantoms().isEmpty()) {
      throw InputException.of(
          "detection '%s' does not know its false alarms, expected phantoms=off", model.name());
    }
  }

  private static InputException noScatter(DetectionModel model) {
    return InputException.of(
        "detection '%s' has no rmse, from which detect=chance draws: expected a model"
            + " that has one, detect=probability or detect=threshold",
        model.name());
  }

  /**
   * Returns the detection for a camera that looks from above or below; its model takes distances
   * over the ground.
   *
   * @param rise the height of the camera above the part to be seen, in metres
   * @param foreshortened whether targets seen from above look shorter
   */
  public Detection inSpace(double rise, boolean foreshortened) {
    return model.flat()
        ? this
        : inSpace.computeIfAbsent(
            new InSpace(model, rise, foreshortened),
            modelInSpace -> new Detection(name, modelInSpace, rule, threshold, chance));
  }

  /** The name in result files. */
  public String name() {
    return name;
  }

  /** The detection model. */
  public DetectionModel model() {
    return model;
  }

  /** The rule by which a value becomes a detection. */
  public DetectionRule rule() {
    return rule;
  }

  /**
   * The number of phantoms that a camera reports in a step: by the number of false alarms that the
   * model knows, a Poisson variable; else 0 or 1, by the chance of the rule.
   *
   * @param luck the luck, in [0, 1)
   */
  public int phantoms(double luck) {
    return rule.phantoms() > 0 && model.phantoms().isPresent()
        ? poisson(model.phantoms().getAsDouble(), luck)
        : luck < rule.phantoms() ? 1 : 0;
  }

  /** The least number whose cumulative probability exceeds a share. */
  private static int poisson(double mean, double share) {
    int count = 0;
    double chance = StrictMath.exp(-mean);
    double sum = chance;
    while (sum <= share && chance > 0) {
      count++;
      chance *= mean / count;
      sum += chance;
    }
    return count;
  }

  /** Whether no luck is drawn: equal values give equal detections. */
  public boolean certain() {
    return certain;
  }

  /** The least value that is detected; by chance, the value that is detected half of the time. */
  public double threshold() {
    return threshold;
  }

  /** The chance that a target with this value is detected, in [0, 1]; 1 or 0 under a threshold. */
  public double chance(double value) {
    return chance.applyAsDouble(value);
  }

  /**
   * Whether a target with this value is detected; NaN never is. The transmittance multiplies the
   * value under a threshold, and otherwise the chance.
   *
   * @param luck the luck of the pair of camera and target, in [0, 1); ignored under a threshold
   * @param transmittance the part of the target's light that reaches the camera, in [0, 1]
   */
  public boolean detects(double value, double luck, double transmittance) {
    return certain
        ? transmittance > 0 && value * transmittance >= threshold
        : luck < transmittance * chance(value);
  }

  /**
   * Returns this detection with a threshold that is at least the given one; the same at every call,
   * so that all runs share what is computed for it.
   */
  public Detection withThresholdFrom(double least) {
    return threshold >= least
        ? this
        : byThreshold.computeIfAbsent(least, raised -> new Detection(model, raised));
  }

  /** The distances detected at a zoom level; the model must not depend on the bearing. */
  public DetectedDistances distances(double size, ZoomLevel zoom) {
    return distances.computeIfAbsent(
        new SizeAtZoom(size, zoom), key -> DetectedDistances.of(model, size, zoom, threshold));
  }

  /** The distances at which targets are in view at a zoom level, detected or not. */
  public DetectedDistances distancesInView(double size, ZoomLevel zoom) {
    return distancesInView.computeIfAbsent(
        new SizeAtZoom(size, zoom), key -> DetectedDistances.of(IN_VIEW, size, zoom, 1));
  }

  /** The chances at a zoom level by distance; the model must not depend on the bearing. */
  public ChanceTable chances(double size, ZoomLevel zoom) {
    return chances.computeIfAbsent(
        new SizeAtZoom(size, zoom), key -> new ChanceTable(this, size, zoom));
  }

  /** The model's values at a zoom level by distance; it must not depend on the bearing. */
  public DistanceTable values(double size, ZoomLevel zoom) {
    return values.computeIfAbsent(
        new SizeAtZoom(size, zoom),
        key ->
            DistanceTable.of(zoom.radius(), distance -> model.confidence(size, distance, 0, zoom)));
  }

  private record SizeAtZoom(double size, ZoomLevel zoom) {}
}
