package org.hificamsim.runs;

import java.util.function.BiPredicate;
import java.util.function.ToDoubleFunction;

/** The way in which a metric is computed. */
sealed interface MetricSource {
  /** Computes a metric from the run alone; NaN if the run does not have the metric. */
  record RunAlone(ToDoubleFunction<Measured> value) implements MetricSource {}

  /**
   * Computes a metric from a run and the yardsticks of its comparison.
   *
   * @param applies decides whether a run has the metric; the flag is true if the run's policy is
   *     the optimum
   */
  record Compared(
      ToDoubleFunction<ScoreComparison> value, BiPredicate<ScoreComparison, Boolean> applies)
      implements MetricSource {}
}
