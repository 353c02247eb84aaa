package org.hificamsim.agents.search;

/**
 * What one {@link Worth} may still come to, given {@link Decisions}: bounds from above on the value
 * of every choice that keeps them.
 *
 * <p>One bound lets every open camera cover all that it can at once. The other adds for each open
 * camera the set that gains most, where a target's gain is the slope of the worth's concave
 * majorant: greedy's bound of submodular functions (Nemhauser, Wolsey and Fisher 1978), and the
 * same for a worth that is not concave. The third is that of {@link Prices}.
 */
final class ValueBounds {
  private final CoverageProblem problem;
  private final Decisions decisions;
  private final Worth worth;
  private final Prices prices;
  private final long[] slope;
  private final long[] last;
  private final long[] most;
  private long sure;
  private long top;
  private long bound;

  ValueBounds(CoverageProblem problem, Decisions decisions, Worth worth) {
    this.problem = problem;
    this.decisions = decisions;
    this.worth = worth;
    prices = new Prices(problem, decisions, worth);
    slope = new long[problem.maxTargets()];
    last = new long[problem.maxTargets()];
    most = new long[problem.maxCameras()];
  }

  Worth worth() {
    return worth;
  }

  /** Looks at the decisions as they are now; returns {@link #bound}. */
  long look() {
    lookAtTargets();
    bound = sure;
    for (int i = 0; i < decisions.open(); i++) {
      bound += mostGain(decisions.openCamera(i));
    }
    bound = Math.min(bound, prices.bound());
    return bound();
  }

  /** Tunes its prices, every camera being open; returns {@link #bound}. */
  long tune() {
    prices.tune();
    return look();
  }

  /** Forgets its prices. */
  void reset() {
    prices.clear();
  }

  /** Looks at what the loss of a set depends on alone. */
  void lookAtTargets() {
    sure = 0;
    top = 0;
    for (int target = 0; target < problem.targets(); target++) {
      int k = decisions.k(target);
      int supply = decisions.supply(target);
      long all = worth.of(k + supply);
      sure += worth.of(k);
      top += all;
      slope[target] = worth.slope(k, supply);
      last[target] = supply == 0 ? 0 : all - worth.of(k + supply - 1);
    }
  }

  private long mostGain(int camera) {
    long gain = 0;
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      gain = decisions.isLesser(set) ? gain : Math.max(gain, gain(set));
    }
    most[camera] = gain;
    return gain;
  }

  /** The value that the decisions have come to already. */
  long sure() {
    return sure;
  }

  /** What no choice that keeps the decisions exceeds. */
  long bound() {
    return Math.min(top, bound);
  }

  /** Whether a set may still lead to this value. */
  boolean allows(int camera, int set, long goal) {
    return top - loss(camera, set) >= goal;
  }

  /** What the set gains at most. */
  long gain(int set) {
    long gain = 0;
    for (int word = 0; word < problem.words(); word++) {
      for (long bits = problem.mask(set, word); bits != 0; bits &= bits - 1) {
        gain += slope[(word << 6) + Long.numberOfTrailingZeros(bits)];
      }
    }
    return gain;
  }

  /** The most that a set of an open camera gains, at the last {@link #look}. */
  long mostOf(int camera) {
    return most[camera];
  }

  /** Whether more cameras can raise the target's worth. */
  boolean canRise(int target) {
    return slope[target] > 0;
  }

  /** By how much {@link #top} falls when the camera takes this set. */
  private long loss(int camera, int set) {
    long loss = 0;
    for (int word = 0; word < problem.words(); word++) {
      long bits = decisions.any(camera, word) & ~problem.mask(set, word);
      for (; bits != 0; bits &= bits - 1) {
        loss += last[(word << 6) + Long.numberOfTrailingZeros(bits)];
      }
    }
    return loss;
  }
}
