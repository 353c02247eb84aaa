package org.hificamsim.runs.statistics;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.apache.commons.math3.stat.StatUtils;

/**
 * Fisher's randomization test of paired differences (The Design of Experiments, 1935, section 21):
 * if two policies are equal, each difference is as likely to have the other sign. It assumes
 * nothing about the distribution; the p-value is two-sided.
 */
public final class PairedTest {
  /** The largest number of differences for which all choices of signs are tried. */
  static final int MAX_EXACT = 16;

  private static final int DRAWS = 99_999;
  private static final long SEED = 1935;
  private static final double ROUNDING = 1e-12;

  private static final double LEVEL = 0.05;
  private static final double POWER = 0.8;

  private PairedTest() {}

  /**
   * The p-value of the hypothesis that the mean difference is 0.
   *
   * @param differences the differences by seed, none of them NaN
   * @return NaN for fewer than two differences
   */
  public static double p(double[] differences) {
    if (differences.length < 2) {
      return Double.NaN;
    }
    double observed = Math.abs(DoubleStream.of(differences).sum());
    double least = observed - ROUNDING * Math.max(1, observed);
    return differences.length <= MAX_EXACT ? exact(differences, least) : drawn(differences, least);
  }

  private static double exact(double[] differences, double least) {
    int choices = 1 << differences.length;
    int asExtreme = 0;
    for (int signs = 0; signs < choices; signs++) {
      double sum = 0;
      for (int i = 0; i < differences.length; i++) {
        sum += (signs >> i & 1) == 0 ? differences[i] : -differences[i];
      }
      asExtreme += Math.abs(sum) >= least ? 1 : 0;
    }
    return asExtreme / (double) choices;
  }

  /** Draws signs. The observed choice counts as one of them, so that no p-value is 0. */
  private static double drawn(double[] differences, double least) {
    SplittableRandom random = new SplittableRandom(SEED);
    int asExtreme = 1;
    for (int draw = 0; draw < DRAWS; draw++) {
      asExtreme += Math.abs(sumWithRandomSigns(differences, random)) >= least ? 1 : 0;
    }
    return asExtreme / (DRAWS + 1.0);
  }

  /** Flips the sign bits instead of branching, since a random branch is unpredictable. */
  private static double sumWithRandomSigns(double[] differences, SplittableRandom random) {
    double sum = 0;
    long signs = 0;
    for (int i = 0; i < differences.length; i++) {
      signs = i % Long.SIZE == 0 ? random.nextLong() : signs >>> 1;
      long flip = signs << (Long.SIZE - 1);
      sum += Double.longBitsToDouble(Double.doubleToRawLongBits(differences[i]) ^ flip);
    }
    return sum;
  }

  /**
   * Applies Holm's correction for many comparisons to p-values (A Simple Sequentially Rejective
   * Multiple Test Procedure, 1979), so that the probability of any false finding stays below the
   * chosen level. The order is kept; NaN stays NaN and is not counted.
   *
   * @param pValues the p-values of all comparisons that are judged together
   */
  public static double[] corrected(double[] pValues) {
    double[] corrected = new double[pValues.length];
    Arrays.fill(corrected, Double.NaN);
    List<Integer> order = ascending(pValues);
    double largest = 0;
    for (int rank = 0; rank < order.size(); rank++) {
      int index = order.get(rank);
      largest = Math.max(largest, Math.min(1, (order.size() - rank) * pValues[index]));
      corrected[index] = largest;
    }
    return corrected;
  }

  /** The number of p-values that are corrected together: those that are not NaN. */
  public static int tests(double[] pValues) {
    return ascending(pValues).size();
  }

  /**
   * The fewest seeds with which the most extreme differences pass Holm's correction: all of them
   * have the same sign, which has a p-value of 2 / 2^seeds.
   *
   * @param tests the number of p-values that are corrected together
   */
  public static int leastSeeds(int tests) {
    int seeds = 2;
    while (tests * Math.pow(2, 1 - seeds) >= LEVEL) {
      seeds++;
    }
    return seeds;
  }

  /**
   * The number of seeds with which a difference of this size is found with a power of 0.8, at a
   * level of 0.05 over all tests (the normal approximation, with Guenther's correction for the
   * estimated variance, Sample Size Formulas for Normal Theory T Tests, 1981).
   *
   * @param differences the differences by seed, none of them NaN
   * @param tests the number of p-values that are corrected together
   * @return NaN if there is no difference, or fewer than two seeds
   */
  public static double seedsNeeded(double[] differences, int tests) {
    double mean = StatUtils.mean(differences);
    if (differences.length < 2 || mean == 0) {
      return Double.NaN;
    }
    NormalDistribution normal = new NormalDistribution();
    double level = normal.inverseCumulativeProbability(1 - LEVEL / 2 / tests);
    double power = normal.inverseCumulativeProbability(POWER);
    double effect = mean / Math.sqrt(StatUtils.variance(differences));
    double seeds = Math.pow((level + power) / effect, 2) + level * level / 2;
    return Math.max(leastSeeds(tests), Math.ceil(seeds));
  }

  /** The indices of the p-values that are not NaN, by ascending p-value. */
  private static List<Integer> ascending(double[] pValues) {
    return IntStream.range(0, pValues.length)
        .filter(i -> !Double.isNaN(pValues[i]))
        .boxed()
        .sorted(Comparator.comparingDouble(i -> pValues[i]))
        .toList();
  }
}
