package org.hificamsim.agents.search;

import java.util.Arrays;

/**
 * Prices of being covered, by target, that make a low bound (Lagrangian relaxation): every camera
 * sells its dearest set, and every target buys as long as a further camera is worth its price. Any
 * prices of 0 or more bound the value from above; subgradient steps look for low ones.
 */
final class Prices {
  private static final int ROUNDS = 40;

  private final CoverageProblem problem;
  private final Decisions decisions;
  private final Worth worth;
  private final long[] price;
  private final long[] best;
  private final long[] first;
  private final int[] sold;
  private final long[] dearest;

  Prices(CoverageProblem problem, Decisions decisions, Worth worth) {
    this.problem = problem;
    this.decisions = decisions;
    this.worth = worth;
    price = new long[problem.maxTargets()];
    best = new long[problem.maxTargets()];
    first = new long[problem.maxTargets()];
    sold = new int[problem.maxTargets()];
    dearest = new long[problem.maxCameras()];
  }

  /** Makes everything free: the bound says what all open cameras could cover at once. */
  void clear() {
    Arrays.fill(price, 0, problem.targets(), 0);
    Arrays.fill(dearest, 0, problem.cameras(), 0);
  }

  /** Looks for prices with a low bound, every camera being open. */
  void tune() {
    long lowest = Long.MAX_VALUE;
    for (int target = 0; target < problem.targets(); target++) {
      first[target] = worth.slope(0, decisions.supply(target));
      price[target] = first[target] / 2;
    }
    for (int round = 0; round < ROUNDS; round++) {
      sell();
      long bound = bound();
      if (bound < lowest) {
        lowest = bound;
        System.arraycopy(price, 0, best, 0, problem.targets());
      }
      change(round);
    }
    System.arraycopy(best, 0, price, 0, problem.targets());
    sell();
  }

  /** What no choice that keeps the decisions exceeds. */
  long bound() {
    long bound = 0;
    for (int target = 0; target < problem.targets(); target++) {
      bound += worth.surplus(decisions.k(target), decisions.supply(target), price[target]);
    }
    for (int i = 0; i < decisions.open(); i++) {
      bound += dearest[decisions.openCamera(i)];
    }
    return bound;
  }

  private void sell() {
    Arrays.fill(sold, 0, problem.targets(), 0);
    for (int camera = 0; camera < problem.cameras(); camera++) {
      int set = dearestOf(camera);
      dearest[camera] = of(set);
      for (int word = 0; word < problem.words(); word++) {
        CoverageProblem.add(sold, word, problem.mask(set, word), 1);
      }
    }
  }

  private int dearestOf(int camera) {
    int dearestSet = problem.firstSet(camera);
    for (int set = dearestSet + 1; set < problem.endSet(camera); set++) {
      dearestSet = of(set) > of(dearestSet) ? set : dearestSet;
    }
    return dearestSet;
  }

  private long of(int set) {
    long sum = 0;
    for (int word = 0; word < problem.words(); word++) {
      for (long bits = problem.mask(set, word); bits != 0; bits &= bits - 1) {
        sum += price[(word << 6) + Long.numberOfTrailingZeros(bits)];
      }
    }
    return sum;
  }

  private void change(int round) {
    for (int target = 0; target < problem.targets(); target++) {
      int bought = worth.bought(decisions.supply(target), price[target]);
      long step = first[target] / (4 + 2L * round);
      long changed = price[target] + Integer.signum(bought - sold[target]) * step;
      price[target] = Math.max(0, Math.min(first[target], changed));
    }
  }
}
