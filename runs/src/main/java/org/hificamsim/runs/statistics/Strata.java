package org.hificamsim.runs.statistics;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import java.util.function.ToDoubleFunction;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.stat.descriptive.moment.StandardDeviation;
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
    return known().stream().mapToDouble(StatUtils::mean).toArray();
  }

  /** The same scores, each changed by a function. */
  Strata map(DoubleUnaryOperator change) {
    return new Strata(
        Arrays.stream(scores)
            .map(ofScenario -> Arrays.stream(ofScenario).map(change).toArray())
            .toArray(double[][]::new));
  }

  /** The mean of the scenarios' means, with its interval. */
  Estimate mean() {
    return mean(ofScenario -> 1.0 / scenarios());
  }

  /** The mean of all scores, with its interval over the seeds of these scenarios. */
  Estimate meanOfRuns() {
    return mean(ofScenario -> (double) ofScenario.length / runs());
  }

  /** The weighted mean of the scenarios' means; a single scenario has that of its values. */
  private Estimate mean(ToDoubleFunction<double[]> weight) {
    double mean = 0;
    double variance = 0;
    double thirdMoment = 0;
    for (double[] ofScenario : known()) {
      int n = ofScenario.length;
      double part = weight.applyAsDouble(ofScenario);
      double deviation = n > 1 ? new StandardDeviation().evaluate(ofScenario) : 0;
      mean += part * StatUtils.mean(ofScenario);
      variance += part * part * deviation * deviation / n;
      thirdMoment += Math.pow(part * deviation, 3) * Estimate.skewness(ofScenario) / (n * n);
    }
    if (freedom() <= 0) {
      return Estimate.single(runs() == 0 ? Double.NaN : mean);
    }
    boolean isSkewnessKnown = runs() >= Estimate.ENOUGH_SEEDS * scenarios() && variance > 0;
    double skewness = isSkewnessKnown ? thirdMoment / Math.pow(variance, 1.5) : 0;
    return Estimate.around(mean, Math.sqrt(variance), skewness, freedom());
  }

  /** The scores of the scenarios that have one. */
  private List<double[]> known() {
    return Arrays.stream(scores).filter(ofScenario -> ofScenario.length > 0).toList();
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
