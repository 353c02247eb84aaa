package org.hificamsim.solver.way;

import java.util.Arrays;
import org.hificamsim.solver.configuration.BranchAndBound;

/**
 * Finds the best sets of a group of cameras in a step: the greatest worth of its targets less the
 * prices of the sets. At each node the prices of targets are tuned until they show that nothing
 * better follows; the sum of the cameras' greatest gains is a second bound, and orders the search.
 */
final class GroupTree extends GroupPrices implements BranchAndBound.Tree {
  private static final int NODE_ROUNDS = 4;
  private static final int MAX_K = 3;
  private static final int UNKNOWN = -1;

  /** The number of cameras that are still to decide and may detect the target, by moment. */
  private final int[] undecidedCameras;

  private final boolean[] decided;
  private final int[] deciding;

  /** The sets to try, by depth. */
  private final int[][] children;

  private final int[] childCounts;
  private final int[] nextChild;
  private final double[] gain;

  /** The price by the number of cameras that already detect a target, and by moment. */
  private final double[][] nodePrices;

  private final BranchAndBound search = new BranchAndBound();
  private int depth;
  private double paid;

  GroupTree(WayProblem problem, PricedCameras priced) {
    super(problem, priced);
    undecidedCameras = new int[problem.momentCount()];
    decided = new boolean[problem.cameras()];
    deciding = new int[problem.cameras() + 1];
    children = new int[problem.cameras() + 1][priced.maxSets() + 1];
    childCounts = new int[problem.cameras() + 1];
    nextChild = new int[problem.cameras() + 1];
    gain = new double[problem.momentCount()];
    nodePrices = new double[MAX_K][problem.momentCount()];
    for (double[] byMoment : nodePrices) {
      Arrays.fill(byMoment, 0.5);
    }
  }

  @Override
  double closeGap(double bound, long nodes) {
    removeCheapSets(offer());
    clearCoverage();
    for (int i = 0; i < momentCount; i++) {
      undecidedCameras[moments[i]] = 0;
    }
    for (int i = 0; i < cameraCount; i++) {
      decided[i] = false;
      chosen[i] = WayProblem.NOTHING;
      countRest(cameras[i], 1);
    }
    depth = 0;
    paid = 0;
    childCounts[0] = UNKNOWN;
    search.reset();
    return search.search(this, nodes) ? bestValue : bound;
  }

  private void removeCheapSets(double bound) {
    for (int i = 0; i < cameraCount; i++) {
      for (int index = priced.setCount(cameras[i]) - 1; index >= 0; index--) {
        double profit = profit(priced.set(cameras[i], index), targetPrices);
        if (bound - cameraProfit[i] + profit < bestValue - TOLERANCE) {
          priced.remove(cameras[i], index);
        }
      }
    }
  }

  private void countRest(int camera, int change) {
    for (int index = 0; index < priced.setCount(camera); index++) {
      for (int moment : problem.moments(priced.set(camera, index))) {
        undecidedCameras[moment] += seen[moment] ? 0 : change;
        seen[moment] = true;
      }
    }
    for (int index = 0; index < priced.setCount(camera); index++) {
      for (int moment : problem.moments(priced.set(camera, index))) {
        seen[moment] = false;
      }
    }
  }

  @Override
  public int branch() {
    if (childCounts[depth] == UNKNOWN) {
      childCounts[depth] = 0;
      nextChild[depth] = 0;
      if (boundByPrices() > bestValue + TOLERANCE) {
        decide();
      }
    }
    return nextChild[depth] < childCounts[depth] ? children[depth][nextChild[depth]] : NONE;
  }

  /** Tunes the targets' prices until they show that nothing better follows, or for some rounds. */
  private double boundByPrices() {
    double bound = offerRest();
    for (int round = 1; round < NODE_ROUNDS && bound > bestValue + TOLERANCE; round++) {
      changeNodePrices(bound - bestValue);
      bound = offerRest();
    }
    return bound;
  }

  private double offerRest() {
    double bound = -paid;
    for (int i = 0; i < momentCount; i++) {
      int moment = moments[i];
      double price = nodePrice(moment);
      int demand = worth.demand(coverage[moment], undecidedCameras[moment], price);
      bound += worth.value(coverage[moment] + demand) - price * demand;
      shortage[moment] = demand;
      gain[moment] = price;
    }
    for (int i = 0; i < cameraCount; i++) {
      if (!decided[i]) {
        bound += offer(i);
      }
    }
    return bound;
  }

  /** Returns a target's price, which depends on how many cameras already detect it. */
  private double nodePrice(int moment) {
    double most = worth.slope(coverage[moment], undecidedCameras[moment]);
    int k = Math.min(coverage[moment], nodePrices.length - 1);
    return k == 0 ? Math.min(most, targetPrices[moment]) : Math.min(most, nodePrices[k][moment]);
  }

  private double offer(int camera) {
    for (int moment : problem.moments(mostProfitable(camera, gain))) {
      shortage[moment]--;
    }
    return cameraProfit[camera];
  }

  private void changeNodePrices(double surplus) {
    double norm = squaredNorm();
    for (int i = 0; i < momentCount && norm > 0; i++) {
      int moment = moments[i];
      double price = Math.max(0, gain[moment] + surplus * shortage[moment] / norm);
      int k = Math.min(coverage[moment], nodePrices.length - 1);
      (k == 0 ? targetPrices : nodePrices[k])[moment] = price;
    }
  }

  /** Decides about the camera that can gain most; keeps the choice if none can. */
  private void decide() {
    double bound = -paid;
    for (int i = 0; i < momentCount; i++) {
      int moment = moments[i];
      bound += worth.value(coverage[moment]);
      gain[moment] = worth.slope(coverage[moment], undecidedCameras[moment]);
    }
    double greatest = 0;
    int camera = UNKNOWN;
    for (int i = 0; i < cameraCount; i++) {
      if (!decided[i]) {
        double value = offer(i);
        bound += value;
        camera = value > greatest ? i : camera;
        greatest = Math.max(value, greatest);
      }
    }
    if (camera == UNKNOWN) {
      keep();
    } else if (bound > bestValue + TOLERANCE) {
      deciding[depth] = camera;
      listChildren(camera, bestValue + TOLERANCE - bound + greatest);
    }
  }

  /** Lists the camera's sets that may gain enough, the greatest gain first, then nothing. */
  private void listChildren(int camera, double enough) {
    int[] list = children[depth];
    int count = 0;
    for (int index = 0; index < priced.setCount(cameras[camera]); index++) {
      int set = priced.set(cameras[camera], index);
      double value = profit(set, gain);
      if (value > 0 && value > enough) {
        int at = count++;
        for (; at > 0 && profit(list[at - 1], gain) < value; at--) {
          list[at] = list[at - 1];
        }
        list[at] = set;
      }
    }
    if (enough < 0) {
      list[count++] = WayProblem.NOTHING;
    }
    childCounts[depth] = count;
  }

  @Override
  public void take(int set) {
    int camera = deciding[depth];
    decided[camera] = true;
    chosen[camera] = set;
    count(set, 1);
    countRest(cameras[camera], -1);
    paid += prices[set];
    depth++;
    childCounts[depth] = UNKNOWN;
  }

  @Override
  public void refuse(int set) {
    depth--;
    int camera = deciding[depth];
    paid -= prices[set];
    countRest(cameras[camera], 1);
    count(set, -1);
    chosen[camera] = WayProblem.NOTHING;
    decided[camera] = false;
    nextChild[depth]++;
  }
}
