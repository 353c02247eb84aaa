package org.hificamsim.solver.configuration;

import java.util.Arrays;
import org.hificamsim.solver.BitMatrix;

/**
 * Bounds a sum of worths by prices for covering targets (Lagrangian relaxation): every camera
 * offers its most expensive set, and every target buys cameras as long as a further one is worth
 * its price. Any prices bound the sum; {@link #tune} looks for prices with a low bound by
 * multiplicative updates (Arora, Hazan and Kale 2012).
 */
final class Prices {
  private final CoverageProblem problem;
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
  private boolean tuned;
  private long lowestBound;

  Prices(CoverageProblem problem, RemainingSets remaining) {
    this.problem = problem;
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
  boolean tune(TargetWorth worth, long requiredSum, int rounds) {
    startAtHalf(worth);
    double leastRatio = Double.POSITIVE_INFINITY;
    lowestBound = Long.MAX_VALUE;
    for (int round = 0; round < rounds; round++) {
      offerMostExpensiveSets();
      long surplus = bound(worth) - requiredSum;
      lowestBound = Math.min(lowestBound, surplus + requiredSum);
      if (surplus < 0) {
        priceAllSets();
        return false;
      }
      double ratio = surplus / sumOfPrices();
      if (ratio < leastRatio) {
        leastRatio = ratio;
        System.arraycopy(targetPrices, 0, bestTargetPrices, 0, problem.targets());
      }
      changePrices(worth, round);
    }
    System.arraycopy(bestTargetPrices, 0, targetPrices, 0, problem.targets());
    priceAllSets();
    return true;
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
          setPrices[set] = sumOfPrices(set);
          mostExpensive = setPrices[set] > setPrices[mostExpensive] ? set : mostExpensive;
        }
      }
      for (int word = 0; word < problem.words(); word++) {
        BitMatrix.add(offers, word, problem.mask(mostExpensive, word), 1);
      }
    }
  }

  /**
   * Prices all sets, including removed ones, because they may come back before prices are tuned
   * again.
   */
  private void priceAllSets() {
    for (int set = 0; set < problem.sets(); set++) {
      setPrices[set] = sumOfPrices(set);
    }
  }

  private long sumOfPrices(int set) {
    long sum = 0;
    for (int word = 0; word < problem.words(); word++) {
      sum += BitMatrix.sum(targetPrices, word, problem.mask(set, word));
    }
    return sum;
  }

  /** Lowers the prices of targets that are offered more often than demanded; raises the others. */
  private void changePrices(TargetWorth worth, int round) {
    double greatestDifference = 1;
    for (int target = 0; target < problem.targets(); target++) {
      demands[target] = worth.demand(remaining.maxCoverage(target), targetPrices[target]);
      greatestDifference = Math.max(greatestDifference, Math.abs(offers[target] - demands[target]));
    }
    double rate = 1 / (greatestDifference * Math.sqrt(1 + 0.3 * round));
    for (int target = 0; target < problem.targets(); target++) {
      double factor = Math.max(0.1, 1 - rate * (offers[target] - demands[target]));
      targetPrices[target] =
          Math.min(maxTargetPrices[target], (long) (targetPrices[target] * factor));
    }
  }
}
