package org.hificamsim.agents.search;

import java.util.Arrays;

/**
 * One of the sums that an objective compares configurations by, and bounds from above on what it
 * may still come to with the {@link RemainingSets}. Sets with which it cannot reach what is
 * {@linkplain #require required} are removed.
 *
 * <p>Where configurations are compared by the least k, a value of K is required by cutting off the
 * worth of each target at K and requiring as much of all targets together.
 *
 * <p>The bounds: every target is covered by its whole supply. Or, beyond what is sure, every camera
 * adds the set that gains most, where a target's gain is the slope of the worth's concave majorant:
 * greedy's bound of submodular functions (Nemhauser, Wolsey and Fisher 1978), and the same for a
 * worth that is not concave. Or coverage has a price (Lagrangian relaxation): every camera sells
 * its dearest set, every target buys while a further camera is worth its price. Any prices bound
 * the sum; multiplicative updates look for low bounds (Arora, Hazan and Kale 2012).
 */
final class Stage {
  private final CoverageProblem problem;
  private final RemainingSets remaining;
  private final TargetWorth worth;
  private final boolean byLeast;
  private final long[] last;
  private final long[] forced;
  private final long[] slope;
  private final long[] gain;
  private final long[] mostGain;
  private final long[] price;
  private final long[] bestPrice;
  private final long[] maxPrice;
  private final int[] bought;
  private final int[] sold;
  private final long[] setPrice;
  private final long[] dearest;
  private boolean coverableAlone;
  private boolean priced;
  private long tightest;
  private long goal;
  private long sure;
  private long top;

  /**
   * @param byLeast whether the least k counts and not the sum
   */
  Stage(CoverageProblem problem, RemainingSets remaining, TargetWorth worth, boolean byLeast) {
    this.problem = problem;
    this.remaining = remaining;
    this.worth = worth;
    this.byLeast = byLeast;
    int targets = problem.maxTargets();
    last = new long[targets];
    forced = new long[CoverageProblem.wordsFor(targets)];
    slope = new long[targets];
    price = new long[targets];
    bestPrice = new long[targets];
    maxPrice = new long[targets];
    bought = new int[targets];
    sold = new int[targets];
    gain = new long[problem.maxSets()];
    setPrice = new long[problem.maxSets()];
    mostGain = new long[problem.maxCameras()];
    dearest = new long[problem.maxCameras()];
  }

  /** From now on a target that no set has does not count for the least k. */
  void countCoverableAlone() {
    coverableAlone = true;
  }

  private boolean counts(int target) {
    return !coverableAlone || remaining.supply(target) > 0;
  }

  /** Forgets the prices. */
  void reset() {
    priced = false;
  }

  /** From now on a configuration has to have this value or a greater one. */
  void require(long value) {
    if (byLeast) {
      worth.cut((int) value);
      goal = worth.of((int) value) * counted();
    } else {
      goal = value;
    }
  }

  private int counted() {
    int counted = problem.targets();
    for (int target = 0; coverableAlone && target < problem.targets(); target++) {
      counted -= counts(target) ? 0 : 1;
    }
    return counted;
  }

  /** The least difference between two values. */
  long step() {
    return byLeast ? 1 : worth.unit();
  }

  /** A value, counting what the objective counts as 1. */
  long inUnits(long value) {
    return value / step();
  }

  /** The worth of targets, as far as it counts for what is required. */
  TargetWorth worth() {
    return worth;
  }

  /**
   * The value of a configuration.
   *
   * @param coverage by target
   */
  long value(int[] coverage) {
    return byLeast ? least(coverage) : sum(coverage);
  }

  private long least(int[] coverage) {
    int least = problem.cameras();
    for (int target = 0; target < problem.targets(); target++) {
      least = counts(target) ? Math.min(least, coverage[target]) : least;
    }
    return least;
  }

  private long sum(int[] coverage) {
    long sum = 0;
    for (int target = 0; target < problem.targets(); target++) {
      sum += worth.of(coverage[target]);
    }
    return sum;
  }

  /** Whether a configuration has the value required. */
  boolean isReached(int[] coverage) {
    return sum(coverage) >= goal;
  }

  /** Whether the value required is reached whatever is chosen. */
  boolean isSure() {
    return sure >= goal;
  }

  /**
   * Removes sets with which the goal is out of reach, by supply and prices.
   *
   * @return whether the goal is still in reach
   */
  boolean narrow() {
    lookAtTargets();
    return top >= goal && force() && (!priced || dropCheap());
  }

  private void lookAtTargets() {
    sure = 0;
    top = 0;
    for (int target = 0; target < problem.targets(); target++) {
      int k = remaining.sure(target);
      int supply = remaining.supply(target);
      sure += worth.of(k);
      top += worth.of(supply);
      last[target] = supply > k ? worth.gain(supply - 1) : 0;
    }
  }

  /** Cameras must hold targets that cannot do without one of their supply. */
  private boolean force() {
    boolean any = false;
    Arrays.fill(forced, 0, problem.words(), 0);
    for (int target = 0; target < problem.targets(); target++) {
      if (last[target] > top - goal) {
        forced[target >> 6] |= 1L << target;
        any = true;
      }
    }
    for (int i = 0; any && i < remaining.withChoice(); i++) {
      if (!force(remaining.withChoice(i))) {
        return false;
      }
    }
    return true;
  }

  private boolean force(int camera) {
    for (int word = 0; word < problem.words(); word++) {
      long needed = remaining.undecided(camera, word) & forced[word];
      for (int set = problem.firstSet(camera); needed != 0 && set < problem.endSet(camera); set++) {
        boolean lacks = (needed & ~problem.mask(set, word)) != 0;
        if (lacks && remaining.has(set) && !remaining.remove(set)) {
          return false;
        }
      }
    }
    return true;
  }

  private boolean dropCheap() {
    long surplus = priceBound() - goal;
    return surplus >= 0 && dropBelow(setPrice, dearest, surplus);
  }

  /** Removes sets that have less than their camera's most by more than there is to spare. */
  private boolean dropBelow(long[] values, long[] most, long surplus) {
    for (int i = 0; i < remaining.withChoice(); i++) {
      int camera = remaining.withChoice(i);
      if (most[camera] > surplus && remaining.isOpen(camera)) {
        for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
          boolean below = values[set] < most[camera] - surplus;
          if (below && remaining.has(set) && !remaining.remove(set)) {
            return false;
          }
        }
      }
    }
    return true;
  }

  /**
   * Works out what each set gains at most, and removes sets that gain too little.
   *
   * @return whether the goal is still in reach
   */
  boolean weigh() {
    lookAtTargets();
    for (int target = 0; target < problem.targets(); target++) {
      slope[target] = worth.slope(remaining.sure(target), remaining.supply(target));
    }
    long bound = sure;
    for (int i = 0; i < remaining.withChoice(); i++) {
      int camera = remaining.withChoice(i);
      mostGain[camera] = remaining.isOpen(camera) ? findGains(camera) : 0;
      bound += mostGain[camera];
    }
    return bound >= goal && dropBelow(gain, mostGain, bound - goal);
  }

  private long findGains(int camera) {
    long most = 0;
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      if (remaining.has(set)) {
        gain[set] = findGain(camera, set);
        most = Math.max(most, gain[set]);
      }
    }
    return most;
  }

  private long findGain(int camera, int set) {
    long sum = 0;
    for (int word = 0; word < problem.words(); word++) {
      long bits = problem.mask(set, word) & remaining.undecided(camera, word);
      for (; bits != 0; bits &= bits - 1) {
        sum += slope[(word << 6) + Long.numberOfTrailingZeros(bits)];
      }
    }
    return sum;
  }

  /** What a set gains at most, as last {@link #weigh weighed}. */
  long gain(int set) {
    return gain[set];
  }

  /** The most that a set of an open camera gains, as last weighed. */
  long mostGain(int camera) {
    return mostGain[camera];
  }

  /** Whether the target's worth is still open. */
  boolean isOpen(int target) {
    return worth.of(remaining.supply(target)) > worth.of(remaining.sure(target));
  }

  /**
   * How many of the cameras that can cover a target must, beyond those that do in any case; 0 where
   * the goal is in reach without it.
   */
  int lack(int target) {
    int k = remaining.supply(target);
    long least = worth.of(k) - (top - goal);
    while (k > remaining.sure(target) && worth.of(k - 1) >= least) {
      k--;
    }
    return k - remaining.sure(target);
  }

  /** What no value exceeds, by supply and prices. */
  long bound() {
    if (!byLeast) {
      lookAtTargets();
      return priced ? Math.min(top, priceBound()) : top;
    }
    int bound = (int) least(remaining.supply());
    long before = worth.top();
    for (require(bound); priced && priceBound() < goal; require(bound)) {
      bound--;
    }
    require(before);
    return bound;
  }

  private long priceBound() {
    long bound = 0;
    for (int target = 0; target < problem.targets(); target++) {
      bound += worth.profit(remaining.sure(target), remaining.supply(target), price[target]);
    }
    for (int camera = 0; camera < problem.cameras(); camera++) {
      dearest[camera] = dearest(camera);
      bound += dearest[camera];
    }
    return bound;
  }

  private long dearest(int camera) {
    long most = 0;
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      most = remaining.has(set) ? Math.max(most, setPrice[set]) : most;
    }
    return most;
  }

  /**
   * Looks for prices that show that the goal is out of reach, or else for those that leave the
   * least surplus for what they come to.
   *
   * @return whether the goal is still in reach
   */
  boolean tune(int rounds) {
    double least = Double.POSITIVE_INFINITY;
    tightest = Long.MAX_VALUE;
    for (int target = 0; target < problem.targets(); target++) {
      maxPrice[target] = worth.slope(0, remaining.supply(target));
      price[target] = maxPrice[target] / 2;
    }
    priced = true;
    for (int round = 0; round < rounds; round++) {
      sell();
      long surplus = priceBound() - goal;
      tightest = Math.min(tightest, surplus + goal);
      if (surplus < 0) {
        return false;
      }
      double all = 1;
      for (int target = 0; target < problem.targets(); target++) {
        all += price[target];
      }
      if (surplus / all < least) {
        least = surplus / all;
        System.arraycopy(price, 0, bestPrice, 0, problem.targets());
      }
      changePrices(round);
    }
    System.arraycopy(bestPrice, 0, price, 0, problem.targets());
    sell();
    return true;
  }

  /** The lowest bound of the sum by prices that {@link #tune} met. */
  long tightest() {
    return tightest;
  }

  /** Every camera sells its dearest set. */
  private void sell() {
    Arrays.fill(sold, 0, problem.targets(), 0);
    for (int camera = 0; camera < problem.cameras(); camera++) {
      int most = remaining.first(camera);
      for (int set = most; set < problem.endSet(camera); set++) {
        if (remaining.has(set)) {
          setPrice[set] = priceOf(set);
          most = setPrice[set] > setPrice[most] ? set : most;
        }
      }
      for (int word = 0; word < problem.words(); word++) {
        CoverageProblem.add(sold, word, problem.mask(most, word), 1);
      }
    }
  }

  /** Gives all sets their prices. */
  void priceSets() {
    for (int set = 0; priced && set < problem.sets(); set++) {
      setPrice[set] = priceOf(set);
    }
  }

  private long priceOf(int set) {
    long sum = 0;
    for (int word = 0; word < problem.words(); word++) {
      for (long bits = problem.mask(set, word); bits != 0; bits &= bits - 1) {
        sum += price[(word << 6) + Long.numberOfTrailingZeros(bits)];
      }
    }
    return sum;
  }

  /** Who is sold more often than bought becomes cheaper. */
  private void changePrices(int round) {
    double spread = 1;
    for (int target = 0; target < problem.targets(); target++) {
      bought[target] = worth.bought(remaining.supply(target), price[target]);
      spread = Math.max(spread, Math.abs(sold[target] - bought[target]));
    }
    double rate = 1 / (spread * Math.sqrt(1 + 0.3 * round));
    for (int target = 0; target < problem.targets(); target++) {
      double factor = Math.max(0.1, 1 - rate * (sold[target] - bought[target]));
      price[target] = Math.min(maxPrice[target], (long) (price[target] * factor));
    }
  }
}
