package org.hificamsim.runs.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.apache.commons.math3.distribution.AbstractRealDistribution;
import org.apache.commons.math3.distribution.BetaDistribution;
import org.apache.commons.math3.distribution.BinomialDistribution;
import org.apache.commons.math3.distribution.ExponentialDistribution;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.compare.Ratio;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests how often a 95% interval contains the true value if that is known, for scores in [0, 1]
 * that are skewed, symmetric, tied or often 1, as proportions of an optimum are. With five seeds,
 * Student's interval of skewed scores contains the true value less often ({@code docs/data.md}).
 */
class IntervalCoverageTest {
  private static final double LEAST = 0.93;
  private static final double LEAST_OF_FEW_SKEWED_SCORES = 0.90;
  private static final double MOST = 0.97;

  /** The standard error of a share in 8000 simulations. */
  private static final double SIMULATION_ERROR = 0.002;

  private final SplittableRandom random = new SplittableRandom(95);

  @ParameterizedTest
  @CsvSource({
    "20, 3, 10",
    "20, 3, 30",
    "8, 2, 10",
    "8, 2, 30",
    "1, 4, 10",
    "1, 4, 30",
    "1, 1, 5",
    "1, 1, 10",
    "1, 1, 30"
  })
  void coversMeanAsOftenAsStated(double alpha, double beta, int seeds) {
    Scores scores = new Scores(new BetaDistribution(alpha, beta));
    assertCovers(8000, LEAST, scores.mean(), () -> Estimate.mean(scores.draw(seeds)));
  }

  @ParameterizedTest
  @CsvSource({"20, 3", "8, 2", "1, 4"})
  void coversMeanOfFewSkewedScoresLessOften(double alpha, double beta) {
    Scores scores = new Scores(new BetaDistribution(alpha, beta));
    assertCovers(
        8000, LEAST_OF_FEW_SKEWED_SCORES, scores.mean(), () -> Estimate.mean(scores.draw(5)));
  }

  @ParameterizedTest
  @CsvSource({"10, 5", "10, 10", "10, 30", "3, 5", "3, 10", "3, 30"})
  void coversMeanOfTiedScoresAsOftenAsStated(int values, int seeds) {
    Scores scores = new Scores(new BinomialDistribution(values, 0.6), values);
    assertCovers(8000, LEAST, scores.mean(), () -> Estimate.mean(scores.draw(seeds)));
  }

  @ParameterizedTest
  @CsvSource({"10", "30"})
  void coversMeanOfScoresThatAreOftenOne(int seeds) {
    Scores scores = new Scores(new NormalDistribution(0.9, 0.12));
    assertCovers(8000, LEAST, scores.mean(), () -> Estimate.mean(scores.draw(seeds)));
  }

  @ParameterizedTest
  @CsvSource({"10", "20", "30"})
  void coversMeanOfVerySkewedScores(int seeds) {
    Scores scores = new Scores(new ExponentialDistribution(1), Double.MAX_VALUE);
    assertCovers(8000, LEAST, scores.mean(), () -> Estimate.mean(scores.draw(seeds)));
  }

  @ParameterizedTest
  @CsvSource({"10", "30"})
  void coversInterquartileMeanAsOftenAsStated(int seeds) {
    Scores scores = new Scores(new BetaDistribution(8, 2));
    double truth = Aggregate.interquartileMean(Strata.of(List.of(scores.quantiles)));
    assertCovers(
        2000, LEAST, truth, () -> Aggregate.IQM.of(Strata.of(List.of(scores.draw(seeds)))));
  }

  @ParameterizedTest
  @CsvSource({"5", "10", "30"})
  void coversShareOfProfileAsOftenAsStatedOnAverage(int seeds) {
    int trials = 300;
    int covered = 0;
    for (int trial = 0; trial < trials; trial++) {
      Estimate[] shares = Aggregate.profile(Strata.of(List.of(random.doubles(seeds).toArray())));
      for (int percent = 5; percent <= 95; percent++) {
        covered += contains(shares[percent], 1 - percent / 100.0) ? 1 : 0;
      }
    }
    assertWithin(LEAST, covered / (91.0 * trials));
  }

  @ParameterizedTest
  @CsvSource({"0.5, 5", "0.5, 10", "0.5, 30", "1.2, 5", "1.2, 10", "1.2, 30", "2, 10"})
  void coversProbabilityOfImprovementAsOftenAsStated(double distance, int seeds) {
    NormalDistribution normal = new NormalDistribution();
    Scores policy = new Scores(new NormalDistribution(distance, 1), Double.MAX_VALUE);
    Scores other = new Scores(normal, Double.MAX_VALUE);
    assertCovers(
        4000,
        LEAST,
        normal.cumulativeProbability(distance / Math.sqrt(2)),
        () ->
            Aggregate.improvement(
                Strata.of(List.of(policy.draw(seeds))), Strata.of(List.of(other.draw(seeds)))));
  }

  @ParameterizedTest
  @CsvSource({"5", "10", "30"})
  void coversRatioOfSumsAsOftenAsStated(int seeds) {
    Scores scores = new Scores(new BetaDistribution(8, 2));
    assertCovers(
        1200,
        seeds < 10 ? LEAST_OF_FEW_SKEWED_SCORES : LEAST,
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
    Scores high = new Scores(new BetaDistribution(8, 2));
    Scores low = new Scores(new BetaDistribution(2, 8));
    assertCovers(
        4000,
        seeds < 10 ? 0.92 : LEAST,
        (high.mean() + low.mean()) / 2,
        () -> {
          Strata strata = Strata.of(List.of(high.draw(seeds), low.draw(seeds)));
          return Aggregate.MEAN.of(strata);
        });
  }

  @ParameterizedTest
  @CsvSource({"5", "10", "30"})
  void bootstrapOfMeanHasNearlySameInterval(int seeds) {
    double[] scores = new Scores(new BetaDistribution(8, 2)).draw(seeds);
    Estimate mean = Estimate.mean(scores);
    Estimate bootstrap =
        Bootstrap.of(
            seeds, drawn -> Arrays.stream(drawn).mapToDouble(i -> scores[i]).sum() / seeds);
    double width = mean.high() - mean.low();
    assertEquals(mean.low(), bootstrap.low(), 0.1 * width);
    assertEquals(mean.high(), bootstrap.high(), 0.1 * width);
  }

  @Test
  void symmetricValuesHaveStudentsInterval() {
    Estimate mean = Estimate.mean(new double[] {1, 2, 3, 4, 5});
    assertEquals(3 + 2.776445 * Math.sqrt(2.5 / 5), mean.high(), 1e-6); // t with 4 degrees: 2.776
    assertEquals(3 - 2.776445 * Math.sqrt(2.5 / 5), mean.low(), 1e-6);
  }

  @Test
  void tenSeedsLengthenIntervalTowardsScatter() {
    double[] values = {0.1, 0.1, 0.1, 0.1, 0.2, 0.2, 0.2, 0.2, 0.2, 0.9};
    Estimate mean = Estimate.mean(values);
    assertEquals(0.116843, mean.low(), 1e-6); // Hall's polynomial, solved by SciPy's brentq
    assertEquals(0.531202, mean.high(), 1e-6); // 1.75 times as long as Student's
    Estimate few = Estimate.mean(Arrays.copyOfRange(values, 1, 10));
    assertEquals(few.mean() - few.low(), few.high() - few.mean(), 1e-12);
  }

  @Test
  void intervalsOfEqualScoresAreNotEmpty() {
    Strata best = Strata.of(List.of(new double[] {1, 1, 1, 1, 1}));
    Strata worst = Strata.of(List.of(new double[] {0, 0, 0, 0, 0}));
    Estimate share = Aggregate.profile(best)[50];
    assertEquals(1, share.high());
    assertEquals(0.565518, share.low(), 1e-6); // SciPy: binomtest(5, 5).proportion_ci, Wilson
    Estimate better = Aggregate.improvement(best, worst);
    assertEquals(1, better.high());
    assertTrue(better.low() > 0.5 && better.low() < 0.8, better.toString());
  }

  private static void assertCovers(
      int trials, double least, double truth, Supplier<Estimate> interval) {
    assertWithin(least, share(trials, truth, interval));
  }

  private static void assertWithin(double least, double share) {
    assertTrue(
        share >= least && share <= MOST + SIMULATION_ERROR,
        "the interval contains the true value in " + share);
  }

  private static double share(int trials, double truth, Supplier<Estimate> interval) {
    int covered = 0;
    for (int trial = 0; trial < trials; trial++) {
      covered += contains(interval.get(), truth) ? 1 : 0;
    }
    return (double) covered / trials;
  }

  private static boolean contains(Estimate estimate, double truth) {
    return estimate.low() <= truth && truth <= estimate.high();
  }

  /** Scores with a distribution that is known by its quantiles. */
  private final class Scores {
    private final double[] quantiles = new double[1000];

    /** Scores of a distribution, cut at 1. */
    Scores(AbstractRealDistribution distribution) {
      this(distribution, 1);
    }

    Scores(AbstractRealDistribution distribution, double most) {
      Arrays.setAll(
          quantiles,
          i ->
              Math.min(
                  most, distribution.inverseCumulativeProbability((i + 0.5) / quantiles.length)));
    }

    Scores(BinomialDistribution distribution, int values) {
      Arrays.setAll(
          quantiles,
          i ->
              (double) distribution.inverseCumulativeProbability((i + 0.5) / quantiles.length)
                  / values);
    }

    double mean() {
      return Arrays.stream(quantiles).average().orElseThrow();
    }

    double[] draw(int seeds) {
      return random.ints(seeds, 0, quantiles.length).mapToDouble(i -> quantiles[i]).toArray();
    }
  }
}
