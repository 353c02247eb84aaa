package org.hificamsim.runs.statistics;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.DoubleStream;

/**
 * Scores by scenario: what is drawn again within each scenario, never across scenarios.
 *
 * @param scores one array per scenario, perhaps empty, of one score per seed
 */
public record Strata(List<double[]> scores) {
  /** Scores that are NaN are left out. */
  public Strata {
    scores =
        scores.stream()
            .map(one -> Arrays.stream(one).filter(score -> !Double.isNaN(score)).toArray())
            .toList();
  }

  /** How many scores there are. */
  public int runs() {
    return scores.stream().mapToInt(one -> one.length).sum();
  }

  /** How many scenarios have a score. */
  public int scenarios() {
    return (int) scores.stream().filter(one -> one.length > 0).count();
  }

  /** Whether drawing again can give anything else. */
  boolean varies() {
    return scores.stream().anyMatch(one -> one.length > 1);
  }

  /** All scores, rising. */
  double[] sorted() {
    return scores.stream().flatMapToDouble(Arrays::stream).sorted().toArray();
  }

  /** The mean of each scenario that has a score. */
  double[] means() {
    return scores.stream()
        .filter(one -> one.length > 0)
        .mapToDouble(one -> DoubleStream.of(one).average().orElseThrow())
        .toArray();
  }

  /** As many scores of each scenario, drawn from its own with replacement. */
  Strata drawn(SplittableRandom random) {
    return new Strata(scores.stream().map(one -> drawn(one, random)).toList());
  }

  private static double[] drawn(double[] scores, SplittableRandom random) {
    double[] drawn = new double[scores.length];
    Arrays.setAll(drawn, i -> scores[random.nextInt(scores.length)]);
    return drawn;
  }
}
