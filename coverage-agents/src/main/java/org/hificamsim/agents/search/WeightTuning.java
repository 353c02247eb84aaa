package org.hificamsim.agents.search;

import java.util.Arrays;

/**
 * Looks for target weights that give a low bound ({@link Weights}): the dual of the coverage
 * problem, by multiplicative updates. Each round lets every camera take its heaviest set; targets
 * that are then covered more than average lose weight, others gain.
 */
final class WeightTuning {
  /** Weights are whole numbers up to this. */
  private static final double SCALE = 1 << 20;

  /** How far below its goal the bound must be, since rounding the weights may raise it again. */
  private static final double MARGIN = 1e-3;

  private final CoverageProblem problem;
  private final double[] weights;
  private final long[] best;
  private final int[] coverage;
  private double lowest;
  private int rounds;

  WeightTuning(CoverageProblem problem) {
    this.problem = problem;
    weights = new double[problem.maxTargets()];
    best = new long[problem.maxTargets()];
    coverage = new int[problem.maxTargets()];
  }

  /** Starts again from equal weights. */
  void reset() {
    Arrays.fill(weights, 0, problem.targets(), 1);
    lowest = Double.POSITIVE_INFINITY;
    rounds = 0;
  }

  /**
   * Continues for some rounds, or until the bound is below {@code goal}.
   *
   * @return the weights with the lowest bound so far, by target
   */
  long[] tune(int more, double goal) {
    for (int end = rounds + more; rounds < end && lowest > goal - MARGIN; rounds++) {
      double bound = bound();
      if (bound < lowest) {
        lowest = bound;
        keep();
      }
      update(bound);
    }
    return best;
  }

  private double bound() {
    Arrays.fill(coverage, 0, problem.targets(), 0);
    double total = 0;
    for (int camera = 0; camera < problem.cameras(); camera++) {
      total += takeHeaviest(camera);
    }
    double all = 0;
    for (int target = 0; target < problem.targets(); target++) {
      all += weights[target];
    }
    return total / all;
  }

  private double takeHeaviest(int camera) {
    int heaviest = problem.firstSet(camera);
    double most = -1;
    for (int set = heaviest; set < problem.endSet(camera); set++) {
      double weight = weight(set);
      if (weight > most) {
        most = weight;
        heaviest = set;
      }
    }
    for (int word = 0; word < problem.words(); word++) {
      CoverageProblem.add(coverage, word, problem.mask(heaviest, word), 1);
    }
    return most;
  }

  private double weight(int set) {
    double weight = 0;
    for (int word = 0; word < problem.words(); word++) {
      for (long bits = problem.mask(set, word); bits != 0; bits &= bits - 1) {
        weight += weights[(word << 6) + Long.numberOfTrailingZeros(bits)];
      }
    }
    return weight;
  }

  private void update(double bound) {
    double spread = 1;
    for (int target = 0; target < problem.targets(); target++) {
      spread = Math.max(spread, Math.abs(coverage[target] - bound));
    }
    double step = 1 / (spread * Math.sqrt(1 + 0.3 * rounds));
    double most = 0;
    for (int target = 0; target < problem.targets(); target++) {
      weights[target] *= Math.max(0.1, 1 - step * (coverage[target] - bound));
      most = Math.max(most, weights[target]);
    }
    for (int target = 0; target < problem.targets(); target++) {
      weights[target] /= most;
    }
  }

  private void keep() {
    for (int target = 0; target < problem.targets(); target++) {
      best[target] = Math.round(weights[target] * SCALE);
    }
  }
}
