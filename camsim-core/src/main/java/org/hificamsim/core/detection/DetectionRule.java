package org.hificamsim.core.detection;

import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.registry.Registry;

/**
 * The rule by which a model's value becomes a detection: the setting {@code detect} ({@code
 * docs/detection.md}).
 */
public sealed interface DetectionRule {
  /** The rule as users write it, with the options that differ from their defaults. */
  String text();

  /** Whether no luck is drawn: equal values give equal detections. */
  default boolean certain() {
    return false;
  }

  /** The number of steps for which a camera keeps its luck with a target, 1 or more. */
  default int memory() {
    return 1;
  }

  /**
   * The chance in each step that a camera reports a phantom, a target that is not there, if the
   * model does not know how many there are; 0 if cameras report none.
   */
  default double phantoms() {
    return 0;
  }

  /**
   * Parses a rule.
   *
   * @throws org.hificamsim.core.InputException if the name is unknown or an option is invalid
   */
  static DetectionRule parse(String text) {
    return rules().create(text);
  }

  /** All rules by name. */
  static Registry<DetectionRule> rules() {
    return new Registry<DetectionRule>("detection rule")
        .register("threshold", "where the value reaches a threshold", Threshold::new)
        .register("chance", "by chance, from the scatter of the model's fit", Chance::from)
        .register("probability", "by chance; the value is the probability", Probability::from);
  }

  /** Detects a target if its value reaches a threshold: the rule of the thesis. */
  record Threshold() implements DetectionRule {
    @Override
    public boolean certain() {
      return true;
    }

    @Override
    public String text() {
      return "threshold";
    }
  }

  /**
   * Detects a target with the chance that its measured confidence, the value plus its {@link
   * Scatter}, reaches the threshold of a rate of false alarms and is not a false alarm. False
   * alarms happen with or without the target, and cover nothing.
   *
   * @param alpha the rate of false alarms, (0, 0.5]
   * @param memory the steps for which a camera keeps its luck with a target, 1 or more
   * @param withPhantoms whether cameras report phantoms
   */
  record Chance(double alpha, int memory, boolean withPhantoms) implements DetectionRule {
    /** The rate of false alarms of {@code chance} without options. */
    public static final double DEFAULT_ALPHA = 0.05;

    private static final double MIN_ALPHA = 1e-9;

    private static Chance from(Options options) {
      return new Chance(
          options.number(
              "alpha",
              DEFAULT_ALPHA,
              MIN_ALPHA,
              0.5,
              "rate of false alarms, which sets the threshold"),
          memoryFrom(options),
          phantomsFrom(options, "on: each camera, each step, a false alarm by alpha"));
    }

    @Override
    public double phantoms() {
      return withPhantoms ? alpha : 0;
    }

    @Override
    public String text() {
      return spelled(
          "chance",
          alpha == DEFAULT_ALPHA ? "" : "alpha=" + alpha,
          memory == 1 ? "" : "memory=" + memory,
          withPhantoms ? "phantoms=on" : "");
    }
  }

  /**
   * Detects a target with a chance that equals its value, clamped to [0, 1].
   *
   * @param memory the steps for which a camera keeps its luck with a target, 1 or more
   * @param withPhantoms whether cameras report phantoms, as many as the model knows
   */
  record Probability(int memory, boolean withPhantoms) implements DetectionRule {
    private static Probability from(Options options) {
      return new Probability(
          memoryFrom(options),
          phantomsFrom(options, "on: each camera, each step, the false alarms of the model"));
    }

    @Override
    public double phantoms() {
      return withPhantoms ? 1 : 0;
    }

    @Override
    public String text() {
      return spelled(
          "probability", memory == 1 ? "" : "memory=" + memory, withPhantoms ? "phantoms=on" : "");
    }
  }

  private static String spelled(String name, String... options) {
    String given =
        Stream.of(options).filter(option -> !option.isEmpty()).collect(Collectors.joining(","));
    return given.isEmpty() ? name : name + ":" + given;
  }

  private static boolean phantomsFrom(Options options, String meaning) {
    return options.choice("phantoms", Phantoms.OFF, meaning) == Phantoms.ON;
  }

  private static int memoryFrom(Options options) {
    return options.integer(
        "memory", 1, 1, 1_000_000, "steps for which a camera keeps its luck with a target");
  }

  /** The values of the option {@code phantoms}. */
  enum Phantoms {
    OFF,
    ON
  }
}
