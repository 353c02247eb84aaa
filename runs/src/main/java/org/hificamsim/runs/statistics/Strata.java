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
 * @param scores the scores of each scenario, one for each seed; may be empty
 */
public record Strata(double[][] scores) {
  /** The scores that are not NaN. */
  public static Strata of(List<double[]> scores) {
    return new Strata(scores.stream().map(Estimate::known).toArray(double[][]::new));
  }

  /** The number of scores. */
  public int runs() {
    return Arrays.stream(scores).mapToInt(scenarioScores -> scenarioScores.length).sum();
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
    for (double[] scenarioScores : scores) {
      System.arraycopy(scenarioScores, 0, sorted, filled, scenarioScores.length);
      filled += scenarioScores.length;
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

  /** Applies a function to each score. */
  Strata map(DoubleUnaryOperator change) {
    return new Strata(
        Arrays.stream(scores)
            .map(scenarioScores -> Arrays.stream(scenarioScores).map(change).toArray())
            .toArray(double[][]::new));
  }

  /** The mean of the scenarios' means, with its interval. */
  Estimate mean() {
    return mean(scenarioScores -> 1.0 / scenarios());
  }

  /** The mean of all scores, with its interval over the seeds of these scenarios. */
  Estimate meanOfRuns() {
    return mean(scenarioScores -> (double) scenarioScores.length / runs());
  }

  /** The weighted mean of the scenarios' means, with its interval. */
  private Estimate mean(ToDoubleFunction<double[]> weight) {
    double mean = 0;
    double variance = 0;
    double thirdMoment = 0;
    for (double[] scenarioScores : known()) {
      int n = scenarioScores.length;
      double part = weight.applyAsDouble(scenarioScores);
      double deviation = n > 1 ? new StandardDeviation().evaluate(scenarioScores) : 0;
      mean += part * StatUtils.mean(scenarioScores);
      variance += part * part * deviation * deviation / n;
      thirdMoment += Math.pow(part * deviation, 3) * Estimate.skewness(scenarioScores) / (n * n);
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
    return Arrays.stream(scores).filter(scenarioScores -> scenarioScores.length > 0).toList();
  }

  /** Draws as many scores of each scenario as it has, with replacement. */
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
