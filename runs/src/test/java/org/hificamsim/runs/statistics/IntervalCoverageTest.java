package org.hificamsim.runs.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.apache.commons.math3.distribution.BetaDistribution;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.compare.Ratio;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests how often a 95% interval contains the true value if that is known, for skewed scores in [0,
 * 1], which proportions of an optimum are like.
 */
class IntervalCoverageTest {
  private static final double LEAST = 0.93;
  private static final double MOST = 0.97;

  private final SplittableRandom random = new SplittableRandom(95);

  @ParameterizedTest
  @CsvSource({"20, 3, 5", "8, 2, 5", "8, 2, 10", "8, 2, 30", "1, 4, 5", "1, 4, 10", "1, 4, 30"})
  void coversMeanAsOftenAsStated(double alpha, double beta, int seeds) {
    Scores scores = new Scores(alpha, beta);
    assertHolds(8000, scores.mean(), () -> Estimate.mean(scores.draw(seeds)));
  }

  @ParameterizedTest
  @CsvSource({"5", "10", "30"})
  void coversRatioOfSumsAsOftenAsStated(int seeds) {
    Scores scores = new Scores(8, 2);
    assertHolds(
        1200,
        scores.mean(),
        () -> {
          double[] optimum = random.doubles(seeds, 200, 300).toArray();
          double[] performance = scores.draw(seeds);
          Arrays.setAll(performance, i -> performance[i] * optimum[i]);
          return new Ratio(performance, optimum).estimate();
        });
  }

  @ParameterizedTest
  @CsvSource({"5", "10", "30"})
  void coversMeanOverScenariosAsOftenAsStated(int seeds) {
    Scores high = new Scores(8, 2);
    Scores low = new Scores(2, 8);
    assertHolds(
        400,
        (high.mean() + low.mean()) / 2,
        () -> {
          Strata strata = Strata.of(List.of(high.draw(seeds), low.draw(seeds)));
          return Bootstrap.all(drawn -> new double[] {Aggregate.MEAN.of(drawn)}, strata)[0];
        });
  }

  @ParameterizedTest
  @CsvSource({"5", "10", "30"})
  void drawnMeanHasNearlySameInterval(int seeds) {
    double[] scores = new Scores(8, 2).draw(seeds);
    Estimate mean = Estimate.mean(scores);
    Estimate drawn =
        Bootstrap.of(
            seeds, again -> Arrays.stream(again).mapToDouble(i -> scores[i]).sum() / seeds);
    double width = mean.high() - mean.low();
    assertEquals(mean.low(), drawn.low(), 0.1 * width);
    assertEquals(mean.high(), drawn.high(), 0.1 * width);
  }

  @Test
  void symmetricValuesHaveStudentsInterval() {
    Estimate mean = Estimate.mean(new double[] {1, 2, 3, 4, 5});
    assertEquals(3 + 2.776445 * Math.sqrt(2.5 / 5), mean.high(), 1e-6); // t with 4 degrees: 2.776
    assertEquals(3 - 2.776445 * Math.sqrt(2.5 / 5), mean.low(), 1e-6);
  }

  @Test
  void intervalIsLongerOnTheSideOfMoreScatter() {
    Estimate mean = Estimate.mean(new double[] {0.1, 0.1, 0.2, 0.2, 0.9});
    assertTrue(mean.high() - mean.mean() > 2 * (mean.mean() - mean.low()));
  }

  private static void assertHolds(int trials, double truth, Supplier<Estimate> interval) {
    int held = 0;
    for (int trial = 0; trial < trials; trial++) {
      Estimate estimate = interval.get();
      held += estimate.low() <= truth && truth <= estimate.high() ? 1 : 0;
    }
    double share = (double) held / trials;
    assertTrue(share >= LEAST && share <= MOST, "the interval holds the truth in " + share);
  }

  /** Scores with a beta distribution. */
  private final class Scores {
    private final BetaDistribution distribution;
    private final double[] quantiles = new double[10_000];

    Scores(double alpha, double beta) {
      distribution = new BetaDistribution(alpha, beta);
      Arrays.setAll(
          quantiles, i -> distribution.inverseCumulativeProbability((i + 0.5) / quantiles.length));
    }

    double mean() {
      return Arrays.stream(quantiles).average().orElseThrow();
    }

    double[] draw(int seeds) {
      return random.ints(seeds, 0, quantiles.length).mapToDouble(i -> quantiles[i]).toArray();
    }
  }
}
