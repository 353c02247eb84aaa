package org.hificamsim.runs.statistics;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.apache.commons.math3.stat.StatUtils;

/**
 * Scores by scenario: what is drawn again within each scenario, never across scenarios. Scores know
 * their places among all of them, so that those drawn by the thousand are put in order by counting.
 */
public final class Strata {
  private final double[] rising;
  private final int[][] places;

  /**
   * @param scores one array per scenario, perhaps empty, of one score per seed; those that are NaN
   *     are left out
   */
  public Strata(List<double[]> scores) {
    List<double[]> known = scores.stream().map(Strata::known).toList();
    rising = known.stream().flatMapToDouble(Arrays::stream).sorted().toArray();
    places = known.stream().map(this::places).toArray(int[][]::new);
  }

  /**
   * @param rising all scores that can be drawn, rising
   * @param places of the scores in {@code rising}, by scenario
   */
  private Strata(double[] rising, int[][] places) {
    this.rising = rising;
    this.places = places;
  }

  private static double[] known(double[] scores) {
    return Arrays.stream(scores).filter(score -> !Double.isNaN(score)).toArray();
  }

  private int[] places(double[] scores) {
    return Arrays.stream(scores).mapToInt(score -> Arrays.binarySearch(rising, score)).toArray();
  }

  /** The scores of each scenario. */
  public List<double[]> scores() {
    return Stream.of(places).map(this::at).toList();
  }

  private double[] at(int[] of) {
    double[] scores = new double[of.length];
    for (int i = 0; i < of.length; i++) {
      scores[i] = rising[of[i]];
    }
    return scores;
  }

  /** How many scores there are. */
  public int runs() {
    return Stream.of(places).mapToInt(one -> one.length).sum();
  }

  /** How many scenarios have a score. */
  public int scenarios() {
    return (int) Stream.of(places).filter(one -> one.length > 0).count();
  }

  /** Whether drawing again can give anything else. */
  boolean varies() {
    return Stream.of(places).anyMatch(one -> one.length > 1);
  }

  /** All scores, rising. */
  double[] sorted() {
    int[] counts = new int[rising.length];
    for (int[] one : places) {
      for (int place : one) {
        counts[place]++;
      }
    }
    double[] sorted = new double[runs()];
    int filled = 0;
    for (int place = 0; place < counts.length; place++) {
      for (int i = 0; i < counts[place]; i++) {
        sorted[filled++] = rising[place];
      }
    }
    return sorted;
  }

  /** The scores of each scenario, rising. */
  List<double[]> sortedByScenario() {
    return Stream.of(places).map(this::sorted).toList();
  }

  private double[] sorted(int[] of) {
    int[] order = of.clone();
    Arrays.sort(order);
    return at(order);
  }

  /** The mean of each scenario that has a score. */
  double[] means() {
    return scores().stream().filter(one -> one.length > 0).mapToDouble(StatUtils::mean).toArray();
  }

  /** As many scores of each scenario, drawn from its own with replacement. */
  Strata drawn(SplittableRandom random) {
    int[][] drawn = new int[places.length][];
    for (int scenario = 0; scenario < drawn.length; scenario++) {
      drawn[scenario] = drawn(places[scenario], random);
    }
    return new Strata(rising, drawn);
  }

  private static int[] drawn(int[] places, SplittableRandom random) {
    int[] drawn = new int[places.length];
    for (int i = 0; i < drawn.length; i++) {
      drawn[i] = places[random.nextInt(places.length)];
    }
    return drawn;
  }
}
