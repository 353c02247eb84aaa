package org.hificamsim.hifi;

import org.hificamsim.core.detection.Condition;
import org.hificamsim.core.detection.Conditions;
import org.hificamsim.hifi.FittedOn.Span;

/**
 * What a condition does to a confidence: it is as that of a target whose share of the image is
 * {@code exp(weight (value - mean))} times as large. Beyond the values of the photos, the nearest
 * of them counts.
 *
 * @param weight what a unit of the condition adds to the natural logarithm of the share
 * @param mean of the photos; the value where the scenario gives none
 * @param photographed the values of the photos
 */
public record CovariateTerm(Condition condition, double weight, double mean, Span photographed) {
  /** What is added to the logarithm of the share. */
  double shift(Conditions conditions) {
    double value = conditions.value(condition);
    return Double.isNaN(value) ? 0 : weight * (photographed.held(value) - mean);
  }
}
