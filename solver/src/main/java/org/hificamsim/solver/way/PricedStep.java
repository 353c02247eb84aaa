package org.hificamsim.solver.way;

import java.util.Arrays;

/**
 * Finds the best sets of all cameras in a step if each set has a price: the score of the step less
 * the prices. If the score is the least k of the targets, each least k from 1 on is a sum of its
 * own, in which a missing camera costs more than that k is worth.
 */
final class PricedStep {
  private final WayProblem problem;
  private final PricedCameras priced;
  private final GroupTree[] trees;
  private final StepWorth scoreWorth;
  private final boolean byLeast;
  private final boolean isShare;
  private final int[] trial;
  private final int[] used;
  private final int[] greatestLeast;
  private final long nodes;

  /**
   * @param nodes the number of search nodes of a group of cameras after which a bound is taken
   */
  PricedStep(WayProblem problem, long nodes) {
    this.problem = problem;
    this.nodes = nodes;
    priced = new PricedCameras(problem);
    byLeast = problem.objective().isLeast();
    isShare = problem.objective().isShare();
    scoreWorth = byLeast ? null : StepGuide.worth(problem.objective(), problem.cameras());
    trial = new int[problem.cameras()];
    used = new int[problem.cameras()];
    greatestLeast = byLeast ? greatestLeast() : new int[problem.steps()];
    int levels = Math.max(1, Arrays.stream(greatestLeast).max().orElse(1));
    trees = new GroupTree[levels];
    Arrays.setAll(trees, level -> new GroupTree(problem, priced));
  }

  /** Returns for each step the least number of cameras that may detect any of its targets. */
  private int[] greatestLeast() {
    int[] coverable = problem.coverable();
    int[] greatest = new int[problem.steps()];
    for (int step = 0; step < greatest.length; step++) {
      greatest[step] =
          Arrays.stream(coverable, problem.start(step), problem.end(step)).min().orElse(0);
    }
    return greatest;
  }

  /** Returns an upper bound of the step's score less prices, exact within the nodes. */
  double solve(int step, double[] prices) {
    Arrays.fill(used, WayProblem.NOTHING);
    int count = problem.end(step) - problem.start(step);
    if (count == 0) {
      return 0;
    }
    if (!byLeast) {
      return solve(step, prices, scaled(isShare ? 1.0 / count : 1), trees[0], used);
    }
    double best = 0;
    for (int least = 1; least <= greatestLeast[step]; least++) {
      double value = solve(step, prices, covering(least), trees[least - 1], trial);
      double score = least - (double) least * least * count + value;
      if (score > best) {
        best = score;
        System.arraycopy(trial, 0, used, 0, used.length);
      }
    }
    return best;
  }

  private StepWorth scaled(double scale) {
    return new StepWorth(Arrays.stream(scoreWorth.values()).map(value -> value * scale).toArray());
  }

  /**
   * Returns worths by which a camera that is missing for a least k costs as much as this k is
   * worth.
   */
  private static StepWorth covering(int least) {
    double[] values = new double[least + 1];
    Arrays.setAll(values, k -> (double) least * k);
    return new StepWorth(values);
  }

  private double solve(int step, double[] prices, StepWorth worth, GroupTree tree, int[] result) {
    priced.fill(step, prices, worth);
    double sum = 0;
    for (int camera = 0; camera < problem.cameras(); camera++) {
      if (priced.setCount(camera) > 0 && priced.group(camera) == camera) {
        sum += tree.solve(camera, worth, prices, nodes, result);
      } else if (priced.setCount(camera) == 0) {
        result[camera] = WayProblem.NOTHING;
      }
    }
    return sum;
  }

  /** The set that a camera detects in the last solution. */
  int used(int camera) {
    return used[camera];
  }
}
