package org.hificamsim.placement.cover;

import java.util.Arrays;
import java.util.Comparator;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

/**
 * A bound on what any plan can reach, by Lagrangian relaxation: seeing a sample has a price of its
 * own, its multiplier, so that candidates no longer depend on each other (Beasley, EJOR 31(1),
 * 1987, for set cover; the same for coverage within a budget, whose price is a multiplier too).
 * Whatever the multipliers are, the bound holds; subgradient steps make it better.
 *
 * <p>With the multipliers of a greedy plan, units where a sample is still to be seen and 0
 * elsewhere, it is the data-dependent bound of submodular maximisation: what the plan is worth and
 * the best further gains.
 */
public final class Duals {
  private static final int PATIENCE = 10;
  private static final double EPSILON = 1e-12;

  private final CoverInstance instance;
  private final Goal goal;
  private final double quantum;
  private final double[] multipliers;
  private final double[] best;
  private final double[] sums; // of multipliers, by candidate
  private double threshold = 1; // of the last evaluation: the worth of a price of 1
  private double bound;
  private double scale = 1;
  private int idle;

  /**
   * @param counts how often a first plan sees each sample
   */
  Duals(CoverInstance instance, Goal goal, int[] counts) {
    this.instance = instance;
    this.goal = goal;
    this.quantum = goal.quantum(instance);
    this.multipliers = new double[instance.samples()];
    this.sums = new double[instance.candidates()];
    if (goal.isAll()) {
      Arrays.fill(multipliers, Double.POSITIVE_INFINITY);
      for (int j = 0; j < sums.length; j++) {
        double share = instance.prices()[j] / instance.columns()[j].length;
        for (int sample : instance.columns()[j]) {
          multipliers[sample] = Math.min(multipliers[sample], share);
        }
      }
    }
    for (int s = 0; s < multipliers.length; s++) {
      boolean open = counts[s] < instance.needs()[s];
      multipliers[s] =
          instance.needs()[s] == 0 ? 0 : goal.isAll() ? multipliers[s] : open ? unit(s) : 0;
    }
    this.best = multipliers.clone();
    bound = value(instance, goal, multipliers, sums);
    threshold = threshold(instance, goal, sums);
  }

  private double unit(int sample) {
    return instance.units()[sample];
  }

  /** No plan is worth more; or, where everything is to be seen, costs less. */
  double bound() {
    return goal.tightened(bound, quantum);
  }

  /** The candidates that a better plan may have, and those of the best so far: rising. */
  int[] open(double score, int[] plan) {
    goBack();
    double value = value(instance, goal, best, sums);
    return IntStream.range(0, sums.length)
        .filter(
            j -> {
              double worth = Math.min(0, sums[j] - threshold * instance.prices()[j]);
              double with = goal.tightened(value + (goal.isAll() ? -worth : worth), quantum);
              return !goal.closes(with, score) || Arrays.binarySearch(plan, j) >= 0;
            })
        .toArray();
  }

  /** The candidates that cost least beyond what they are worth, and those of a plan: rising. */
  int[] kernel(int count, int[] plan) {
    goBack();
    IntStream first =
        IntStream.range(0, sums.length)
            .boxed()
            .sorted(Comparator.comparingDouble(this::reducedPrice))
            .limit(count)
            .mapToInt(Integer::intValue);
    return IntStream.concat(first, Arrays.stream(plan)).distinct().sorted().toArray();
  }

  /** The multipliers that prove the bound, by sample. */
  double[] proof() {
    return best.clone();
  }

  /**
   * The bound that multipliers prove.
   *
   * @param multipliers by sample, 0 or more
   */
  public static double value(CoverInstance instance, Goal goal, double[] multipliers) {
    double value = value(instance, goal, multipliers, new double[instance.candidates()]);
    return goal.tightened(value, goal.quantum(instance));
  }

  private static double value(
      CoverInstance instance, Goal goal, double[] multipliers, double[] sums) {
    double value = 0;
    for (int s = 0; s < multipliers.length; s++) {
      double left = instance.units()[s] - multipliers[s];
      double each = goal.isAll() ? multipliers[s] : Math.max(0, left);
      value += instance.needs()[s] * each;
    }
    for (int j = 0; j < sums.length; j++) {
      sums[j] = 0;
      for (int sample : instance.columns()[j]) {
        sums[j] += multipliers[sample];
      }
    }
    double threshold = threshold(instance, goal, sums);
    double above = 0;
    for (int j = 0; j < sums.length; j++) {
      above += Math.max(0, sums[j] - threshold * instance.prices()[j]);
    }
    return goal.isAll() ? value - above : value + above + threshold * goal.budget();
  }

  /** The worth of a price of 1 at which what is worth it just uses up the budget. */
  private static double threshold(CoverInstance instance, Goal goal, double[] sums) {
    if (goal.isAll()) {
      return 1;
    }
    double low = 0;
    double high = 0;
    for (int j = 0; j < sums.length; j++) {
      high = Math.max(high, sums[j] / instance.prices()[j]);
    }
    for (int i = 0; i < 60 && high - low > EPSILON * high; i++) {
      double middle = (low + high) / 2;
      double spent = 0;
      for (int j = 0; j < sums.length; j++) {
        spent += sums[j] > middle * instance.prices()[j] ? instance.prices()[j] : 0;
      }
      if (spent > goal.budget()) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return high;
  }

  /**
   * Subgradient steps (Held, Wolfe and Crowder 1974).
   *
   * @param score of the best plan so far
   */
  void improve(int steps, double score, BooleanSupplier stop) {
    for (int i = 0; i < steps && !isClosed(score) && !stop.getAsBoolean(); i++) {
      step(score);
    }
  }

  boolean isClosed(double score) {
    return goal.closes(bound(), score);
  }

  private void step(double score) {
    double[] seen = new double[instance.samples()];
    double tied = 0;
    double left = goal.budget();
    for (int j = 0; j < sums.length; j++) {
      double above = sums[j] - threshold * instance.prices()[j];
      double margin = 1e-9 * threshold * instance.prices()[j];
      if (above > margin) {
        add(seen, j, 1);
        left -= instance.prices()[j];
      } else if (above >= -margin && !goal.isAll()) {
        tied += instance.prices()[j];
      }
    }
    double share = tied > 0 ? Math.max(0, Math.min(1, left / tied)) : 0;
    for (int j = 0; j < sums.length && share > 0; j++) {
      double margin = 1e-9 * threshold * instance.prices()[j];
      if (Math.abs(sums[j] - threshold * instance.prices()[j]) <= margin) {
        add(seen, j, share);
      }
    }
    move(seen, Math.abs(bound - score));
    double value = value(instance, goal, multipliers, sums);
    threshold = threshold(instance, goal, sums);
    boolean better = goal.isAll() ? value > bound : value < bound;
    idle = better ? 0 : idle + 1;
    if (better) {
      bound = value;
      System.arraycopy(multipliers, 0, best, 0, best.length);
    } else if (idle % PATIENCE == 0) {
      scale /= 2;
      goBack();
    }
  }

  /** To the best multipliers; returns their value. */
  private double goBack() {
    System.arraycopy(best, 0, multipliers, 0, best.length);
    double value = value(instance, goal, multipliers, sums);
    threshold = threshold(instance, goal, sums);
    return value;
  }

  private void add(double[] seen, int candidate, double share) {
    for (int sample : instance.columns()[candidate]) {
      seen[sample] += share;
    }
  }

  /** A step against what is seen too often, within the limits of multipliers. */
  private void move(double[] seen, double gap) {
    double square = 0;
    for (int s = 0; s < seen.length; s++) {
      seen[s] = instance.needs()[s] == 0 ? 0 : instance.needs()[s] - seen[s];
      boolean outwards =
          (seen[s] < 0 && multipliers[s] == 0)
              || (seen[s] > 0 && !goal.isAll() && multipliers[s] == unit(s));
      seen[s] = outwards ? 0 : seen[s];
      square += seen[s] * seen[s];
    }
    double length = square == 0 ? 0 : scale * Math.max(gap, 1e-3) / square;
    for (int s = 0; s < seen.length; s++) {
      double most = goal.isAll() ? Double.MAX_VALUE : unit(s);
      multipliers[s] = Math.max(0, Math.min(most, multipliers[s] + length * seen[s]));
    }
  }

  /** Whether the steps have become too small to matter. */
  boolean isSpent() {
    return scale < 1e-4;
  }

  /** What a candidate costs beyond what it is worth by the last multipliers. */
  double reducedPrice(int candidate) {
    return instance.prices()[candidate] - sums[candidate] / Math.max(threshold, EPSILON);
  }
}
