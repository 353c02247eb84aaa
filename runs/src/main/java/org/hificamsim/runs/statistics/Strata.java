package org.hificamsim.runs.statistics;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.runs.Estimate;

/**
 * Scores by scenario: what is drawn again within each scenario, never across scenarios.
 *
 * @param scores one array per scenario, perhaps empty, of one score per seed
 */
public record Strata(double[][] scores) {
  /** Those of scores that are not NaN. */
  public static Strata of(List<double[]> scores) {
    return new Strata(scores.stream().map(Estimate::known).toArray(double[][]::new));
  }

  /** How many scores there are. */
  public int runs() {
    int runs = 0;
    for (double[] one : scores) {
      runs += one.length;
    }
    return runs;
  }

  /** How many scenarios have a score. */
  public int scenarios() {
    return means().length;
  }

  /**
   * How many scores could differ from the means of their scenarios: 0 where none is drawn again.
   */
  int freedom() {
    return runs() - scenarios();
  }

  /** All scores, rising. */
  double[] sorted() {
    double[] all = new double[runs()];
    int filled = 0;
    for (double[] one : scores) {
      System.arraycopy(one, 0, all, filled, one.length);
      filled += one.length;
    }
    Arrays.sort(all);
    return all;
  }

  /** The scores of each scenario, rising. */
  double[][] sortedByScenario() {
    double[][] rising = new double[scores.length][];
    for (int scenario = 0; scenario < rising.length; scenario++) {
      rising[scenario] = scores[scenario].clone();
      Arrays.sort(rising[scenario]);
    }
    return rising;
  }

  /** The mean of each scenario that has a score. */
  double[] means() {
    return Arrays.stream(scores)
        .filter(one -> one.length > 0)
        .mapToDouble(StatUtils::mean)
        .toArray();
  }

  /** As many scores of each scenario, drawn from its own with replacement. */
  Strata drawn(SplittableRandom random) {
    double[][] drawn = new double[scores.length][];
    for (int scenario = 0; scenario < drawn.length; scenario++) {
      double[] own = scores[scenario];
      drawn[scenario] = new double[own.length];
      Arrays.setAll(drawn[scenario], i -> own[random.nextInt(own.length)]);
    }
    return new Strata(drawn);
  }
}
