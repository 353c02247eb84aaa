package org.hificamsim.solver.way;

import java.util.Arrays;
import org.hificamsim.solver.Exchange;
import org.hificamsim.solver.PriceSearch;

/**
 * A group of cameras in a step and the prices of its targets (Lagrangian relaxation): each camera
 * offers its most profitable set, and each target buys as many cameras as are worth its price. Any
 * prices bound the worth of the targets less the prices of the sets.
 */
abstract class GroupPrices implements PriceSearch.Relaxation, Exchange.Choice {
  private static final int ROUNDS = 12;
  private static final int PASSES = 4;
  private static final PriceSearch.Pace PACE = new PriceSearch.Pace(1, 1, 0.5, 1, false);
  static final double TOLERANCE = 1e-9;

  final WayProblem problem;
  final PricedCameras priced;

  /** The price of each moment, which is kept between calls. */
  final double[] targetPrices;

  /** The prices of moments with the lowest bound in this call. */
  private final double[] bestTargetPrices;

  final int[] coverage;

  final int[] cameras;
  final int[] chosen;
  private final int[] best;
  final double[] cameraProfit;
  final int[] moments;

  /** The number of cameras that a target demands beyond those that are offered, by moment. */
  final double[] shortage;

  final boolean[] seen;

  private final PriceSearch search = new PriceSearch(this, PACE);

  StepWorth worth;
  double[] prices;
  int cameraCount;
  int momentCount;
  double bestValue;

  GroupPrices(WayProblem problem, PricedCameras priced) {
    this.problem = problem;
    this.priced = priced;
    targetPrices = new double[problem.momentCount()];
    Arrays.fill(targetPrices, Double.NaN);
    bestTargetPrices = new double[problem.momentCount()];
    coverage = new int[problem.momentCount()];
    shortage = new double[problem.momentCount()];
    seen = new boolean[problem.momentCount()];
    cameras = new int[problem.cameras()];
    chosen = new int[problem.cameras()];
    best = new int[problem.cameras()];
    cameraProfit = new double[problem.cameras()];
    moments = new int[problem.maxMoments()];
  }

  /**
   * Solves the problem of a group.
   *
   * @param group the number of the group
   * @param used receives the best set of each camera of the group
   * @return an upper bound of the value; the value itself if the search ends within the nodes
   */
  double solve(int group, StepWorth newWorth, double[] newPrices, long nodes, int[] used) {
    worth = newWorth;
    prices = newPrices;
    collect(group);
    bestValue = 0;
    Arrays.fill(best, 0, cameraCount, WayProblem.NOTHING);
    double bound = search.search(ROUNDS);
    if (bound > bestValue + TOLERANCE) {
      bound = Math.min(bound, closeGap(bound, nodes));
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

  @Override
  public final double solveParts() {
    return offer();
  }

  @Override
  public final void keepPrices() {
    copyPrices(targetPrices, bestTargetPrices);
  }

  @Override
  public final void restorePrices() {
    copyPrices(bestTargetPrices, targetPrices);
  }

  @Override
  public final boolean isDone() {
    return search.lowest() <= bestValue + TOLERANCE;
  }

  private void copyPrices(double[] from, double[] to) {
    for (int i = 0; i < momentCount; i++) {
      to[moments[i]] = from[moments[i]];
    }
  }

  /**
   * Lets every camera offer its most profitable set, and returns the bound by the present prices.
   */
  final double offer() {
    clearCoverage();
    double bound = 0;
    for (int i = 0; i < cameraCount; i++) {
      chosen[i] = mostProfitable(i, targetPrices);
      bound += cameraProfit[i];
      count(chosen[i], 1);
    }
    for (int i = 0; i < momentCount; i++) {
      int moment = moments[i];
      bound += worth.profit(0, priced.maxCoverage(moment), targetPrices[moment]);
      shortage[moment] =
          worth.demand(0, priced.maxCoverage(moment), targetPrices[moment]) - coverage[moment];
    }
    return bound;
  }

  /**
   * Returns the set with which a camera of the group makes the greatest profit, and stores the
   * profit; {@link WayProblem#NOTHING} if there is no profit.
   */
  final int mostProfitable(int camera, double[] pricesByMoment) {
    double greatest = 0;
    int most = WayProblem.NOTHING;
    for (int index = 0; index < priced.setCount(cameras[camera]); index++) {
      int set = priced.set(cameras[camera], index);
      double profit = profit(set, pricesByMoment);
      if (profit > greatest) {
        greatest = profit;
        most = set;
      }
    }
    cameraProfit[camera] = greatest;
    return most;
  }

  /** The sum of the prices of a set's targets, less its own price. */
  final double profit(int set, double[] pricesByMoment) {
    double profit = -prices[set];
    for (int moment : problem.moments(set)) {
      profit += pricesByMoment[moment];
    }
    return profit;
  }

  /** The sum of the squares of all shortages. */
  final double squaredNorm() {
    double norm = 0;
    for (int i = 0; i < momentCount; i++) {
      norm += shortage[moments[i]] * shortage[moments[i]];
    }
    return norm;
  }

  @Override
  public final void changePrices() {
    double surplus = search.pace() * (search.value() - bestValue);
    double norm = squaredNorm();
    for (int i = 0; i < momentCount; i++) {
      int moment = moments[i];
      double change = norm == 0 ? 0 : surplus * shortage[moment] / norm;
      double most = worth.slope(0, priced.maxCoverage(moment));
      targetPrices[moment] = Math.min(most, Math.max(0, targetPrices[moment] + change));
    }
  }

  final void clearCoverage() {
    for (int i = 0; i < momentCount; i++) {
      coverage[moments[i]] = 0;
    }
  }

  final void count(int set, int change) {
    for (int moment : problem.moments(set)) {
      coverage[moment] += change;
    }
  }

  /** Exchanges sets from those that are offered as long as the value rises. */
  @Override
  public final void improvePlan() {
    Exchange.improve(this, PASSES);
    keep();
  }

  @Override
  public final int choosers() {
    return cameraCount;
  }

  @Override
  public final boolean exchange(int camera) {
    int before = chosen[camera];
    count(before, -1);
    chosen[camera] = mostGaining(cameras[camera], before);
    count(chosen[camera], 1);
    return chosen[camera] != before;
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

  final void keep() {
    double value = 0;
    for (int i = 0; i < momentCount; i++) {
      value += worth.value(coverage[moments[i]]);
    }
    for (int i = 0; i < cameraCount; i++) {
      value -= prices[chosen[i]];
    }
    if (value > bestValue) {
      bestValue = value;
      System.arraycopy(chosen, 0, best, 0, cameraCount);
    }
  }

  /**
   * Searches for the greatest value below the bound.
   *
   * @return a bound of the value; the value itself if the search ends within the nodes
   */
  abstract double closeGap(double bound, long nodes);
}
