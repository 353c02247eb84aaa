package org.hificamsim.agents.ways;

import java.util.Arrays;
import org.hificamsim.agents.search.BranchAndBound;

/**
 * Finds what a group of cameras detects best in a step: the worth of its targets less the prices of
 * the sets. Prices of targets (Lagrangian relaxation) bound the value, remove sets, and order the
 * search; a second bound is the sum of the cameras' greatest gains.
 */
final class GroupTree implements BranchAndBound.Tree {
  private static final int ROUNDS = 12;
  private static final int NODE_ROUNDS = 4;
  private static final int MAX_K = 3;
  private static final int UNKNOWN = -1;
  private static final double TOLERANCE = 1e-9;

  private final WayProblem problem;
  private final PricedCameras priced;

  /** By moment: its price, kept from call to call, and the best one of a call. */
  private final double[] targetPrices;

  private final double[] bestTargetPrices;
  private final int[] coverage;

  /** By moment: the cameras that are still to decide and may detect it. */
  private final int[] rest;

  private final int[] cameras;
  private final boolean[] decided;
  private final int[] deciding;

  /** By depth, the sets to try. */
  private final int[][] children;

  private final int[] childCounts;
  private final int[] nextChild;
  private final int[] chosen;
  private final int[] best;
  private final double[] cameraProfit;
  private final int[] moments;
  private final double[] mark;
  private final double[] gain;
  private final boolean[] seen;

  /** By the number of cameras that detect a target already, and by moment: its price. */
  private final double[][] nodePrices;

  private final BranchAndBound search = new BranchAndBound();
  private Worth worth;
  private double[] prices;
  private int cameraCount;
  private int momentCount;
  private int depth;
  private double paid;
  private double bestValue;

  GroupTree(WayProblem problem, PricedCameras priced) {
    this.problem = problem;
    this.priced = priced;
    targetPrices = new double[problem.momentCount()];
    Arrays.fill(targetPrices, Double.NaN);
    bestTargetPrices = new double[problem.momentCount()];
    coverage = new int[problem.momentCount()];
    rest = new int[problem.momentCount()];
    mark = new double[problem.momentCount()];
    gain = new double[problem.momentCount()];
    seen = new boolean[problem.momentCount()];
    nodePrices = new double[MAX_K][problem.momentCount()];
    for (double[] byMoment : nodePrices) {
      Arrays.fill(byMoment, 0.5);
    }
    cameras = new int[problem.cameras()];
    decided = new boolean[problem.cameras()];
    deciding = new int[problem.cameras() + 1];
    children = new int[problem.cameras() + 1][priced.maxSets() + 1];
    childCounts = new int[problem.cameras() + 1];
    nextChild = new int[problem.cameras() + 1];
    chosen = new int[problem.cameras()];
    best = new int[problem.cameras()];
    cameraProfit = new double[problem.cameras()];
    moments = new int[problem.maxMoments()];
  }

  /**
   * Solves the problem of a group.
   *
   * @param group its number
   * @param used receives the set that each camera of the group detects best
   * @return an upper bound of the value; the value itself if the search ends within the nodes
   */
  double solve(int group, Worth newWorth, double[] newPrices, long nodes, int[] used) {
    worth = newWorth;
    prices = newPrices;
    collect(group);
    bestValue = 0;
    Arrays.fill(best, 0, cameraCount, WayProblem.NOTHING);
    double bound = tune();
    if (bound > bestValue + TOLERANCE) {
      bound = Math.min(bound, close(bound, nodes));
    }
    for (int i = 0; i < cameraCount; i++) {
      used[cameras[i]] = best[i];
    }
    return Math.max(bound, bestValue);
  }

  private void collect(int group) {
    cameraCount = 0;
    momentCount = 0;
    for (int camera = 0; camera < problem.cameras(); camera++) {
      if (priced.setCount(camera) > 0 && priced.group(camera) == group) {
        cameras[cameraCount++] = camera;
        for (int i = 0; i < priced.setCount(camera); i++) {
          collectMoments(priced.set(camera, i));
        }
      }
    }
    for (int i = 0; i < momentCount; i++) {
      seen[moments[i]] = false;
    }
  }

  private void collectMoments(int set) {
    for (int moment : problem.moments(set)) {
      if (!seen[moment]) {
        seen[moment] = true;
        moments[momentCount++] = moment;
        coverage[moment] = 0;
        double most = worth.slope(0, priced.maxCoverage(moment));
        double price = targetPrices[moment];
        targetPrices[moment] = Double.isNaN(price) ? most / 2 : Math.min(price, most);
      }
    }
  }

  /** Changes the prices of targets against the bound; returns the least one. */
  private double tune() {
    double least = Double.POSITIVE_INFINITY;
    double pace = 1;
    for (int round = 0; round < ROUNDS && least > bestValue + TOLERANCE; round++) {
      double bound = offer();
      if (bound < least) {
        least = bound;
        copyPrices(targetPrices, bestTargetPrices);
      } else {
        pace /= 2;
      }
      improve();
      changePrices(pace * (bound - bestValue));
    }
    copyPrices(bestTargetPrices, targetPrices);
    return least;
  }

  private void copyPrices(double[] from, double[] to) {
    for (int i = 0; i < momentCount; i++) {
      to[moments[i]] = from[moments[i]];
    }
  }

  /** Every camera offers its most profitable set; returns the bound by the present prices. */
  private double offer() {
    clearCoverage();
    double bound = 0;
    for (int i = 0; i < cameraCount; i++) {
      chosen[i] = WayProblem.NOTHING;
      double greatest = 0;
      for (int index = 0; index < priced.setCount(cameras[i]); index++) {
        int set = priced.set(cameras[i], index);
        double profit = profit(set);
        if (profit > greatest) {
          greatest = profit;
          chosen[i] = set;
        }
      }
      cameraProfit[i] = greatest;
      bound += greatest;
      count(chosen[i], 1);
    }
    for (int i = 0; i < momentCount; i++) {
      int moment = moments[i];
      bound += worth.profit(0, priced.maxCoverage(moment), targetPrices[moment]);
      mark[moment] =
          worth.demand(0, priced.maxCoverage(moment), targetPrices[moment]) - coverage[moment];
    }
    return bound;
  }

  private double profit(int set) {
    double profit = -prices[set];
    for (int moment : problem.moments(set)) {
      profit += targetPrices[moment];
    }
    return profit;
  }

  private void changePrices(double surplus) {
    double norm = 0;
    for (int i = 0; i < momentCount; i++) {
      norm += mark[moments[i]] * mark[moments[i]];
    }
    for (int i = 0; i < momentCount; i++) {
      int moment = moments[i];
      double change = norm == 0 ? 0 : surplus * mark[moment] / norm;
      double most = worth.slope(0, priced.maxCoverage(moment));
      targetPrices[moment] = Math.min(most, Math.max(0, targetPrices[moment] + change));
    }
  }

  private void clearCoverage() {
    for (int i = 0; i < momentCount; i++) {
      coverage[moments[i]] = 0;
    }
  }

  private void count(int set, int change) {
    for (int moment : problem.moments(set)) {
      coverage[moment] += change;
    }
  }

  /** Exchanges sets from those that are offered as long as the value rises. */
  private void improve() {
    boolean better = true;
    for (int pass = 0; better && pass < 4; pass++) {
      better = false;
      for (int i = 0; i < cameraCount; i++) {
        int before = chosen[i];
        count(before, -1);
        chosen[i] = mostGaining(cameras[i], before);
        count(chosen[i], 1);
        better |= chosen[i] != before;
      }
    }
    keep();
  }

  private int mostGaining(int camera, int before) {
    double greatest = before == WayProblem.NOTHING ? 0 : gain(before);
    int most = greatest > 0 ? before : WayProblem.NOTHING;
    greatest = Math.max(0, greatest);
    for (int index = 0; index < priced.setCount(camera); index++) {
      double gain = gain(priced.set(camera, index));
      if (gain > greatest + TOLERANCE) {
        greatest = gain;
        most = priced.set(camera, index);
      }
    }
    return most;
  }

  private double gain(int set) {
    double gain = -prices[set];
    for (int moment : problem.moments(set)) {
      gain += worth.gain(coverage[moment]);
    }
    return gain;
  }

  private void keep() {
    double value = 0;
    for (int i = 0; i < momentCount; i++) {
      value += worth.of(coverage[moments[i]]);
    }
    for (int i = 0; i < cameraCount; i++) {
      value -= prices[chosen[i]];
    }
    if (value > bestValue) {
      bestValue = value;
      System.arraycopy(chosen, 0, best, 0, cameraCount);
    }
  }

  /** Removes sets by the bound, and searches the others; returns a bound of the value. */
  private double close(double bound, long nodes) {
    removeCheapSets(offer());
    clearCoverage();
    for (int i = 0; i < momentCount; i++) {
      rest[moments[i]] = 0;
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
        double profit = profit(priced.set(cameras[i], index));
        if (bound - cameraProfit[i] + profit < bestValue - TOLERANCE) {
          priced.remove(cameras[i], index);
        }
      }
    }
  }

  private void countRest(int camera, int change) {
    for (int index = 0; index < priced.setCount(camera); index++) {
      for (int moment : problem.moments(priced.set(camera, index))) {
        rest[moment] += seen[moment] ? 0 : change;
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
      int demand = worth.demand(coverage[moment], rest[moment], price);
      bound += worth.of(coverage[moment] + demand) - price * demand;
      mark[moment] = demand;
      gain[moment] = price;
    }
    for (int i = 0; i < cameraCount; i++) {
      if (!decided[i]) {
        bound += offer(i);
      }
    }
    return bound;
  }

  /** The price of a target that some cameras detect already is one of its own. */
  private double nodePrice(int moment) {
    double most = worth.slope(coverage[moment], rest[moment]);
    int k = Math.min(coverage[moment], nodePrices.length - 1);
    return k == 0 ? Math.min(most, targetPrices[moment]) : Math.min(most, nodePrices[k][moment]);
  }

  private double offer(int camera) {
    double greatest = 0;
    int offered = WayProblem.NOTHING;
    for (int index = 0; index < priced.setCount(cameras[camera]); index++) {
      int set = priced.set(cameras[camera], index);
      double value = restGain(set);
      if (value > greatest) {
        greatest = value;
        offered = set;
      }
    }
    for (int moment : problem.moments(offered)) {
      mark[moment]--;
    }
    cameraProfit[camera] = greatest;
    return greatest;
  }

  private double restGain(int set) {
    double sum = -prices[set];
    for (int moment : problem.moments(set)) {
      sum += gain[moment];
    }
    return sum;
  }

  private void changeNodePrices(double surplus) {
    double norm = 0;
    for (int i = 0; i < momentCount; i++) {
      norm += mark[moments[i]] * mark[moments[i]];
    }
    for (int i = 0; i < momentCount && norm > 0; i++) {
      int moment = moments[i];
      double price = Math.max(0, gain[moment] + surplus * mark[moment] / norm);
      int k = Math.min(coverage[moment], nodePrices.length - 1);
      (k == 0 ? targetPrices : nodePrices[k])[moment] = price;
    }
  }

  /** Decides about the camera that can gain most; keeps the choice if none can. */
  private void decide() {
    double bound = -paid;
    for (int i = 0; i < momentCount; i++) {
      int moment = moments[i];
      bound += worth.of(coverage[moment]);
      gain[moment] = worth.slope(coverage[moment], rest[moment]);
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
      double value = restGain(set);
      if (value > 0 && value > enough) {
        int at = count++;
        for (; at > 0 && restGain(list[at - 1]) < value; at--) {
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
