package org.hificamsim.solver.way;

import java.util.Arrays;
import org.hificamsim.solver.BranchAndBound;
import org.hificamsim.solver.BranchList;

/**
 * Finds the best sets of a group of cameras in a step: the greatest worth of its targets less the
 * prices of the sets. At each node the prices of targets are tuned until they show that nothing
 * better follows; the sum of the cameras' greatest gains is a second bound, and orders the search.
 */
final class GroupTree extends GroupPrices implements BranchList.Problem {
  private static final int NODE_ROUNDS = 4;
  private static final int MAX_K = 3;
  private static final int NONE = -1;

  /** The number of cameras that are still to decide and may detect the target, by moment. */
  private final int[] undecidedCameras;

  private final boolean[] decided;

  /** The camera that decides, by depth. */
  private final int[] deciding;

  private final double[] gain;

  /** The price by the number of cameras that already detect a target, and by moment. */
  private final double[][] nodePrices;

  /** The sets of the deciding camera at each depth, the greatest gain first. */
  private final BranchList branches;

  private final BranchAndBound search = new BranchAndBound();
  private double paid;

  GroupTree(WayProblem problem, PricedCameras priced) {
    super(problem, priced);
    undecidedCameras = new int[problem.momentCount()];
    decided = new boolean[problem.cameras()];
    deciding = new int[problem.cameras() + 1];
    branches = new BranchList(this, problem.cameras());
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
    paid = 0;
    branches.begin();
    search.reset();
    return search.search(branches, nodes) ? bestValue : bound;
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
  public void list(int depth) {
    if (boundByPrices() > bestValue + TOLERANCE) {
      decide(depth);
    }
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
  private void decide(int depth) {
    double bound = -paid;
    for (int i = 0; i < momentCount; i++) {
      int moment = moments[i];
      bound += worth.value(coverage[moment]);
      gain[moment] = worth.slope(coverage[moment], undecidedCameras[moment]);
    }
    double greatest = 0;
    int camera = NONE;
    for (int i = 0; i < cameraCount; i++) {
      if (!decided[i]) {
        double value = offer(i);
        bound += value;
        camera = value > greatest ? i : camera;
        greatest = Math.max(value, greatest);
      }
    }
    if (camera == NONE) {
      keep();
    } else if (bound > bestValue + TOLERANCE) {
      deciding[depth] = camera;
      listSets(camera, bestValue + TOLERANCE - bound + greatest);
    }
  }

  /** Lists the camera's sets that may gain enough, the greatest gain first, then nothing. */
  private void listSets(int camera, double enough) {
    for (int index = 0; index < priced.setCount(cameras[camera]); index++) {
      int set = priced.set(cameras[camera], index);
      double value = profit(set, gain);
      if (value > 0 && value > enough) {
        branches.add(set, value);
      }
    }
    if (enough < 0) {
      branches.add(WayProblem.NOTHING);
    }
  }

  @Override
  public void take(int depth, int set) {
    int camera = deciding[depth];
    decided[camera] = true;
    chosen[camera] = set;
    count(set, 1);
    countRest(cameras[camera], -1);
    paid += prices[set];
  }

  @Override
  public void undo(int depth, int set) {
    int camera = deciding[depth];
    paid -= prices[set];
    countRest(cameras[camera], 1);
    count(set, -1);
    chosen[camera] = WayProblem.NOTHING;
    decided[camera] = false;
  }
}
