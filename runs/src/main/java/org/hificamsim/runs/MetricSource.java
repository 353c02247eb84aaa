package org.hificamsim.runs;

import java.util.function.BiPredicate;
import java.util.function.ToDoubleFunction;

/** How a metric is computed. */
sealed interface MetricSource {
  /** A value of the run alone; NaN if the run does not have the metric. */
  record OfRun(ToDoubleFunction<Measured> value) implements MetricSource {}

  /**
   * From a run and the yardsticks of its comparison.
   *
   * @param applies whether a run has the metric; the flag tells whether its policy is the optimum
   */
  record OfComparison(
      ToDoubleFunction<ScoreComparison> value, BiPredicate<ScoreComparison, Boolean> applies)
      implements MetricSource {}
}
