package org.hificamsim.solver.configuration;

import java.util.Arrays;
import org.hificamsim.solver.BitMatrix;
import org.hificamsim.solver.PriceSearch;

/**
 * Bounds a sum of worths by prices for covering targets (Lagrangian relaxation): every camera
 * offers its most expensive set, and every target buys cameras as long as a further one is worth
 * its price. Any prices bound the sum; {@link #tune} looks for prices with a low bound by
 * multiplicative updates (Arora, Hazan and Kale 2012).
 */
final class Prices implements PriceSearch.Relaxation {
  private final CoverageProblem problem;
  private final BitMatrix masks;
  private final RemainingSets remaining;
  private final long[] targetPrices;
  private final long[] bestTargetPrices;
  private final long[] maxTargetPrices;

  /** The sum of target prices of each set; has to be computed again when target prices change. */
  private final long[] setPrices;

  /** The greatest price of each camera's remaining sets, as of the last {@link #bound}. */
  private final long[] cameraPrices;

  private final int[] offers;
  private final int[] demands;
  private final PriceSearch priceSearch = new PriceSearch(this, PriceSearch.Pace.STEADY);
  private boolean tuned;
  private TargetWorth tunedWorth;
  private long requiredSum;
  private long lastSurplus;
  private long lowestBound;

  Prices(CoverageProblem problem, RemainingSets remaining) {
    this.problem = problem;
    masks = problem.masks();
    this.remaining = remaining;
    int targets = problem.maxTargets();
    targetPrices = new long[targets];
    bestTargetPrices = new long[targets];
    maxTargetPrices = new long[targets];
    offers = new int[targets];
    demands = new int[targets];
    setPrices = new long[problem.maxSets()];
    cameraPrices = new long[problem.maxCameras()];
  }

  /** Forgets all prices: until they are tuned again they show nothing. */
  void reset() {
    tuned = false;
  }

  /** Whether there are prices. */
  boolean areTuned() {
    return tuned;
  }

  /** The lowest bound that the last {@link #tune} found. */
  long lowestBound() {
    return lowestBound;
  }

  /** An upper bound of the sum of worths of any choice among the remaining sets. */
  long bound(TargetWorth worth) {
    long bound = 0;
    for (int target = 0; target < problem.targets(); target++) {
      bound +=
          worth.profit(
              remaining.minCoverage(target), remaining.maxCoverage(target), targetPrices[target]);
    }
    for (int camera = 0; camera < problem.cameras(); camera++) {
      cameraPrices[camera] = greatestSetPrice(camera);
      bound += cameraPrices[camera];
    }
    return bound;
  }

  private long greatestSetPrice(int camera) {
    long greatest = 0;
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      greatest = remaining.has(set) ? Math.max(greatest, setPrices[set]) : greatest;
    }
    return greatest;
  }

  /**
   * Removes the sets that are so cheap that with them the sum is below the one required.
   *
   * @return whether the required sum may still be reached
   */
  boolean removeCheapSets(TargetWorth worth, long requiredSum) {
    long surplus = bound(worth) - requiredSum;
    return surplus >= 0 && remaining.removeBelow(setPrices, cameraPrices, surplus);
  }

  /**
   * Looks for prices that show that a sum is out of reach; otherwise keeps those whose bound
   * exceeds it least in proportion to the sum of the prices.
   *
   * @param rounds how often prices are changed
   * @return whether the required sum may still be reached
   */
  boolean tune(TargetWorth worth, long newRequiredSum, int rounds) {
    tunedWorth = worth;
    requiredSum = newRequiredSum;
    lowestBound = Long.MAX_VALUE;
    startAtHalf(worth);
    priceSearch.search(rounds);
    priceAllSets();
    return lastSurplus >= 0;
  }

  /** Returns how far the bound exceeds the sum, in proportion to the sum of the prices. */
  @Override
  public double solveParts() {
    offerMostExpensiveSets();
    lastSurplus = bound(tunedWorth) - requiredSum;
    lowestBound = Math.min(lowestBound, lastSurplus + requiredSum);
    return lastSurplus / sumOfPrices();
  }

  @Override
  public void keepPrices() {
    System.arraycopy(targetPrices, 0, bestTargetPrices, 0, problem.targets());
  }

  @Override
  public void restorePrices() {
    System.arraycopy(bestTargetPrices, 0, targetPrices, 0, problem.targets());
  }

  /** Whether the last prices show that the sum is out of reach. */
  @Override
  public boolean isDone() {
    return lastSurplus < 0;
  }

  private void startAtHalf(TargetWorth worth) {
    for (int target = 0; target < problem.targets(); target++) {
      maxTargetPrices[target] = worth.slope(0, remaining.maxCoverage(target));
      targetPrices[target] = maxTargetPrices[target] / 2;
    }
    tuned = true;
  }

  /** The sum of prices plus 1, because the sum may be 0. */
  private double sumOfPrices() {
    double sum = 1;
    for (int target = 0; target < problem.targets(); target++) {
      sum += targetPrices[target];
    }
    return sum;
  }

  private void offerMostExpensiveSets() {
    Arrays.fill(offers, 0, problem.targets(), 0);
    for (int camera = 0; camera < problem.cameras(); camera++) {
      int mostExpensive = remaining.first(camera);
      for (int set = mostExpensive; set < problem.endSet(camera); set++) {
        if (remaining.has(set)) {
          setPrices[set] = masks.sum(set, targetPrices);
          mostExpensive = setPrices[set] > setPrices[mostExpensive] ? set : mostExpensive;
        }
      }
      masks.add(mostExpensive, offers, 1);
    }
  }

  /**
   * Prices all sets, including removed ones, because they may come back before prices are tuned
   * again.
   */
  private void priceAllSets() {
    for (int set = 0; set < problem.sets(); set++) {
      setPrices[set] = masks.sum(set, targetPrices);
    }
  }

  /** Lowers the prices of targets that are offered more often than demanded; raises the others. */
  @Override
  public void changePrices() {
    double greatestDifference = 1;
    for (int target = 0; target < problem.targets(); target++) {
      demands[target] = tunedWorth.demand(remaining.maxCoverage(target), targetPrices[target]);
      greatestDifference = Math.max(greatestDifference, Math.abs(offers[target] - demands[target]));
    }
    double rate = 1 / (greatestDifference * Math.sqrt(1 + 0.3 * priceSearch.round()));
    for (int target = 0; target < problem.targets(); target++) {
      double factor = Math.max(0.1, 1 - rate * (offers[target] - demands[target]));
      targetPrices[target] =
          Math.min(maxTargetPrices[target], (long) (targetPrices[target] * factor));
    }
  }
}
