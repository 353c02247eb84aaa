package org.hificamsim.runs;

import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.scenario.Headings;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.StepOrder;

/**
 * What users ask for in place of what the scenario file says. The one place that decides: what is
 * asked for goes before the file, and the file before the default.
 *
 * @param threshold of every detection without one of its own, in [0, 1]
 * @param rule how every detection without a rule of its own decides
 * @param objective what a step is scored by
 */
public record Overrides(
    Optional<Double> threshold,
    Optional<DetectionRule> rule,
    Optional<Objective> objective,
    Optional<StepOrder> order,
    Optional<Headings> headings) {
  /** Nothing is asked for. */
  public static final Overrides NONE = ofDetection(Optional.empty(), Optional.empty());

  /** Checks the threshold. */
  public Overrides {
    threshold.ifPresent(Overrides::checkThreshold);
  }

  /** Nothing but perhaps a threshold or a rule is asked for. */
  public static Overrides ofDetection(Optional<Double> threshold, Optional<DetectionRule> rule) {
    return new Overrides(threshold, rule, Optional.empty(), Optional.empty(), Optional.empty());
  }

  /** The scenario with what is asked for in its place. */
  public Scenario scenario(Scenario file) {
    return rule.map(file::withDetect)
        .orElse(file)
        .with(Scenario.OBJECTIVE, objective.orElse(file.objective()))
        .with(Scenario.ORDER, order.orElse(file.order()))
        .with(Scenario.HEADINGS, headings.orElse(file.headings()));
  }

  /**
   * The detection with the first rule or threshold that there is: its own, the one that is asked
   * for, the scenario's, the default. A threshold asks for the rule of thresholds.
   *
   * @throws InputException when a threshold and a rule of chance are asked for side by side
   */
  public Detection detection(DetectionSpec spec, Scenario scenario) {
    return detection(spec, scenario.threshold(), scenario.detect());
  }

  /** The same where no scenario has a say. */
  public Detection detection(DetectionSpec spec) {
    return detection(spec, OptionalDouble.empty(), Optional.empty());
  }

  Detection detection(
      DetectionSpec spec, OptionalDouble ofScenario, Optional<DetectionRule> ruleOfScenario) {
    DetectionRule first =
        rule(spec).or(() -> ruleOfScenario).orElseGet(DetectionRule.Threshold::new);
    return first.certain()
        ? new Detection(spec.name(first), spec.model(), threshold(spec, ofScenario))
        : Detection.by(first, spec.name(first), spec.model());
  }

  /** The rule that the detection itself or, after it, the user asks for. */
  private Optional<DetectionRule> rule(DetectionSpec spec) {
    if (spec.rule().isPresent() || spec.threshold().isPresent()) {
      return spec.rule().or(() -> Optional.of(new DetectionRule.Threshold()));
    }
    rule.filter(asked -> !asked.certain())
        .ifPresent(asked -> threshold.ifPresent(value -> refuse(value, asked)));
    return rule.or(() -> threshold.map(value -> new DetectionRule.Threshold()));
  }

  private double threshold(DetectionSpec spec, OptionalDouble ofScenario) {
    return spec.threshold()
        .or(() -> threshold)
        .orElseGet(() -> ofScenario.orElse(spec.model().defaultThreshold()));
  }

  private static void refuse(double threshold, DetectionRule asked) {
    throw new InputException(
        "threshold is " + threshold + ", expected none with detect=" + asked.text());
  }

  static void checkThreshold(double threshold) {
    if (!(threshold >= 0 && threshold <= 1)) {
      throw new InputException("threshold is " + threshold + ", expected a number from 0 to 1");
    }
  }
}
