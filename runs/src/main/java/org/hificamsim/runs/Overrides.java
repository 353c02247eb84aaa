package org.hificamsim.runs;

import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Headings;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.StepOrder;

/**
 * What users ask for in place of what the scenario file says. The one place that decides: what is
 * asked for goes before the file, and the file before the default.
 *
 * @param threshold of every detection without one of its own, in [0, 1]
 */
public record Overrides(
    Optional<Double> threshold, Optional<StepOrder> order, Optional<Headings> headings) {
  /** Nothing is asked for. */
  public static final Overrides NONE = ofThreshold(Optional.empty());

  /** Checks the threshold. */
  public Overrides {
    threshold.ifPresent(Overrides::checkThreshold);
  }

  /** Nothing but perhaps a threshold is asked for. */
  public static Overrides ofThreshold(Optional<Double> threshold) {
    return new Overrides(threshold, Optional.empty(), Optional.empty());
  }

  /** The scenario with what is asked for in its place. */
  public Scenario scenario(Scenario file) {
    return file.withOrder(order.orElse(file.order()))
        .withHeadings(headings.orElse(file.headings()));
  }

  /**
   * The detection with the first threshold that there is: its own, the one that is asked for, the
   * scenario's, the model's default.
   */
  public Detection detection(DetectionSpec spec, OptionalDouble ofScenario) {
    double threshold =
        spec.threshold()
            .or(() -> this.threshold)
            .orElseGet(() -> ofScenario.orElse(spec.model().defaultThreshold()));
    return new Detection(spec.name(), spec.model(), threshold);
  }

  static void checkThreshold(double threshold) {
    if (!(threshold >= 0 && threshold <= 1)) {
      throw new InputException("threshold is " + threshold + ", expected a number from 0 to 1");
    }
  }
}
