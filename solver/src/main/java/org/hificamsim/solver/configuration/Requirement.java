package org.hificamsim.solver.configuration;

/**
 * A value by which an objective compares configurations, and how much of it is required: a sum of
 * worths of targets, or the least k.
 *
 * <p>A least k of K is required as a sum, too: the worth of each target is cut off at K, and all
 * targets together have to be worth as much as if each were covered K times.
 */
final class Requirement {
  private final CoverageProblem problem;
  private final RemainingSets remaining;
  private final TargetWorth worth;
  private final boolean byLeast;
  private final boolean coverableOnly;
  private long sum;

  /**
   * @param byLeast whether the value is the least k, and not a sum
   * @param coverableOnly whether targets that no set has are left out of the least k
   */
  Requirement(
      CoverageProblem problem,
      RemainingSets remaining,
      TargetWorth worth,
      boolean byLeast,
      boolean coverableOnly) {
    this.problem = problem;
    this.remaining = remaining;
    this.worth = worth;
    this.byLeast = byLeast;
    this.coverableOnly = coverableOnly;
  }

  /** Requires this value or a greater one. */
  void require(long value) {
    if (byLeast) {
      worth.cut((int) value);
      sum = sumForLeast((int) value, worth);
    } else {
      sum = value;
    }
  }

  /** The sum of worths at which the least k is {@code least}, for a worth cut off there. */
  long sumForLeast(int least, TargetWorth cutWorth) {
    return cutWorth.value(least) * countedTargets();
  }

  private int countedTargets() {
    int counted = problem.targets();
    for (int target = 0; coverableOnly && target < problem.targets(); target++) {
      counted -= counts(target) ? 0 : 1;
    }
    return counted;
  }

  private boolean counts(int target) {
    return !coverableOnly || remaining.maxCoverage(target) > 0;
  }

  /** The sum of worths that is required. */
  long sum() {
    return sum;
  }

  boolean byLeast() {
    return byLeast;
  }

  /** The worth of a target, as far as it counts towards what is required. */
  TargetWorth worth() {
    return worth;
  }

  /** The least difference between two values. */
  long step() {
    return byLeast ? 1 : worth.unit();
  }

  /** The value of a configuration with this coverage, by target. */
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
    long total = 0;
    for (int target = 0; target < problem.targets(); target++) {
      total += worth.value(coverage[target]);
    }
    return total;
  }

  /** Whether a configuration with this coverage has the value required. */
  boolean isMetBy(int[] coverage) {
    return sum(coverage) >= sum;
  }
}
