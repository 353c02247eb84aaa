package org.hificamsim.runs;

import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.scenario.Headings;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.StepOrder;

/**
 * What users ask for in place of what the scenario file says. The one place that decides: what is
 * asked for goes before the file, and the file before the default.
 *
 * @param threshold of every detection without one of its own, in [0, 1]
 * @param rule how every detection without a rule of its own decides
 */
public record Overrides(
    Optional<Double> threshold,
    Optional<DetectionRule> rule,
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
    return new Overrides(threshold, rule, Optional.empty(), Optional.empty());
  }

  /** The scenario with what is asked for in its place. */
  public Scenario scenario(Scenario file) {
    return rule.map(file::withDetect)
        .orElse(file)
        .withOrder(order.orElse(file.order()))
        .withHeadings(headings.orElse(file.headings()));
  }

  /**
   * The detection with the first rule, and the first threshold, that there is: its own, the one
   * that is asked for, the scenario's, the default.
   *
   * @throws InputException when a threshold is asked for where there is none
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
    DetectionRule decides =
        spec.rule().or(() -> rule).or(() -> ruleOfScenario).orElseGet(DetectionRule.Threshold::new);
    String name = spec.name(decides);
    if (decides.certain()) {
      return new Detection(name, spec.model(), threshold(spec, ofScenario));
    }
    spec.threshold()
        .or(() -> spec.rule().isEmpty() ? threshold : Optional.empty())
        .ifPresent(value -> refuse(value, decides));
    return Detection.by(decides, name, spec.model());
  }

  private double threshold(DetectionSpec spec, OptionalDouble ofScenario) {
    return spec.threshold()
        .or(() -> threshold)
        .orElseGet(() -> ofScenario.orElse(spec.model().defaultThreshold()));
  }

  private static void refuse(double threshold, DetectionRule decides) {
    throw new InputException(
        "threshold is " + threshold + ", expected none with detect=" + decides.text());
  }

  static void checkThreshold(double threshold) {
    if (!(threshold >= 0 && threshold <= 1)) {
      throw new InputException("threshold is " + threshold + ", expected a number from 0 to 1");
    }
  }
}
