package org.hificamsim.core.scenario;

import org.hificamsim.core.detection.Condition;
import org.hificamsim.core.detection.Conditions;

/** Reads the conditions of a simulation or camera from its attributes. */
final class ConditionsReader {
  private ConditionsReader() {}

  /** Those that the element says. */
  static Conditions of(Attributes attributes) {
    return new Conditions(
        value(attributes, Condition.APERTURE),
        value(attributes, Condition.DISTORTION),
        value(attributes, Condition.LIGHT));
  }

  private static double value(Attributes attributes, Condition condition) {
    Range range =
        new Range(
            condition.expected(), value -> value >= condition.least() && value <= condition.most());
    return attributes.optionalNumber(condition.key(), range).orElse(Double.NaN);
  }
}
