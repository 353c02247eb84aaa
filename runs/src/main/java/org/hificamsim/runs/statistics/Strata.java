package org.hificamsim.runs.statistics;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.runs.Estimate;

/**
 * Scores by scenario. A bootstrap draws them within each scenario, never across scenarios.
 *
 * @param scores for each scenario an array, which may be empty, with a score for each seed
 */
public record Strata(double[][] scores) {
  /** The scores that are not NaN. */
  public static Strata of(List<double[]> scores) {
    return new Strata(scores.stream().map(Estimate::known).toArray(double[][]::new));
  }

  /** The number of scores. */
  public int runs() {
    return Arrays.stream(scores).mapToInt(ofScenario -> ofScenario.length).sum();
  }

  /** The number of scenarios with a score. */
  public int scenarios() {
    return means().length;
  }

  /**
   * The degrees of freedom: scores minus scenarios. 0 if no scenario has two scores to draw from.
   */
  int freedom() {
    return runs() - scenarios();
  }

  /** All scores in ascending order. */
  double[] sorted() {
    double[] sorted = new double[runs()];
    int filled = 0;
    for (double[] ofScenario : scores) {
      System.arraycopy(ofScenario, 0, sorted, filled, ofScenario.length);
      filled += ofScenario.length;
    }
    Arrays.sort(sorted);
    return sorted;
  }

  /** The scores of each scenario in ascending order. */
  double[][] sortedByScenario() {
    double[][] sorted = new double[scores.length][];
    for (int scenario = 0; scenario < sorted.length; scenario++) {
      sorted[scenario] = scores[scenario].clone();
      Arrays.sort(sorted[scenario]);
    }
    return sorted;
  }

  /** The means of the scenarios that have a score. */
  double[] means() {
    return Arrays.stream(scores)
        .filter(ofScenario -> ofScenario.length > 0)
        .mapToDouble(StatUtils::mean)
        .toArray();
  }

  /** The same number of scores of each scenario, drawn from its scores with replacement. */
  Strata drawn(SplittableRandom random) {
    double[][] drawn = new double[scores.length][];
    for (int scenario = 0; scenario < drawn.length; scenario++) {
      double[] source = scores[scenario];
      drawn[scenario] = new double[source.length];
      Arrays.setAll(drawn[scenario], i -> source[random.nextInt(source.length)]);
    }
    return new Strata(drawn);
  }
}
