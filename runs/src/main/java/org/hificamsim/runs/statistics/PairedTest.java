package org.hificamsim.runs.statistics;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/**
 * Fisher's randomization test of paired differences (The Design of Experiments, 1935, section 21):
 * if two policies were alike, each difference might as well have the other sign. It asks nothing of
 * the distribution; the p-value is two-sided.
 */
public final class PairedTest {
  /** Up to this many differences, every choice of signs is looked at. */
  static final int EXACT = 16;

  private static final int DRAWS = 99_999;
  private static final long SEED = 1935;
  private static final double ROUNDING = 1e-12;

  private PairedTest() {}

  /**
   * The p-value of a mean that is not 0.
   *
   * @param differences by seed, none NaN
   * @return NaN for fewer than two differences
   */
  public static double p(double[] differences) {
    if (differences.length < 2) {
      return Double.NaN;
    }
    double reached = Math.abs(DoubleStream.of(differences).sum());
    double least = reached - ROUNDING * Math.max(1, reached);
    return differences.length <= EXACT ? exact(differences, least) : drawn(differences, least);
  }

  private static double exact(double[] differences, double least) {
    int all = 1 << differences.length;
    int asFar = 0;
    for (int signs = 0; signs < all; signs++) {
      double sum = 0;
      for (int i = 0; i < differences.length; i++) {
        sum += (signs >> i & 1) == 0 ? differences[i] : -differences[i];
      }
      asFar += Math.abs(sum) >= least ? 1 : 0;
    }
    return asFar / (double) all;
  }

  /** What was found is one of the choices of signs: no p-value is 0. */
  private static double drawn(double[] differences, double least) {
    SplittableRandom random = new SplittableRandom(SEED);
    int asFar = 1;
    for (int draw = 0; draw < DRAWS; draw++) {
      asFar += Math.abs(flipped(differences, random)) >= least ? 1 : 0;
    }
    return asFar / (DRAWS + 1.0);
  }

  /** Flips the bit of the sign, by chance: a branch would be guessed wrong half of the time. */
  private static double flipped(double[] differences, SplittableRandom random) {
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
   * P-values after Holm's correction for many comparisons (A Simple Sequentially Rejective Multiple
   * Test Procedure, 1979), in the order of those given: the chance of even one false finding among
   * all stays below the level that is asked for. NaN stays, and is not counted.
   *
   * @param p of all comparisons that are looked at together
   */
  public static double[] corrected(double[] p) {
    double[] corrected = new double[p.length];
    Arrays.fill(corrected, Double.NaN);
    List<Integer> rising = rising(p);
    double most = 0;
    for (int rank = 0; rank < rising.size(); rank++) {
      int at = rising.get(rank);
      most = Math.max(most, Math.min(1, (rising.size() - rank) * p[at]));
      corrected[at] = most;
    }
    return corrected;
  }

  private static List<Integer> rising(double[] p) {
    return IntStream.range(0, p.length)
        .filter(i -> !Double.isNaN(p[i]))
        .boxed()
        .sorted(Comparator.comparingDouble(i -> p[i]))
        .toList();
  }
}
