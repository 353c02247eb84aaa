package org.hificamsim.core.metrics;

/**
 * The coverage of the targets in one step (thesis 7.1, Eq 7.1) and the score of the step; measured
 * again in each step.
 *
 * <p>All values are 0 if no target is present.
 */
public final class StepCoverage {
  private final Objective objective;
  private int targets;
  private int least;
  private int uncovered;
  private int coveredOnceAtMost;
  private long sum;
  private ExpectedCoverage expected;
  private double score;
  private int[] countedK = {};
  private boolean[] coverable = {};

  /** Creates a coverage scored by k_min. */
  public StepCoverage() {
    this(Objective.kMin());
  }

  /** Creates a coverage scored by an objective. */
  public StepCoverage(Objective objective) {
    this.objective = objective;
  }

  /** Measures the last observation. */
  public void measure(CoveredTargets observed) {
    int present = 0;
    int fewest = Integer.MAX_VALUE;
    int none = 0;
    int onceAtMost = 0;
    long all = 0;
    for (int target = 0; target < observed.targets(); target++) {
      if (observed.present(target)) {
        int k = observed.coverage(target);
        present++;
        fewest = Math.min(fewest, k);
        none += isBelow(1, k);
        onceAtMost += isBelow(2, k);
        all += k;
      }
    }
    targets = present;
    least = present == 0 ? 0 : fewest;
    uncovered = none;
    coveredOnceAtMost = onceAtMost;
    sum = all;
  }

  /** Measures the score of the last observation; called after {@link #measure}. */
  public void measureScore(CoverableTargets observed) {
    int count = collect(observed);
    score = objective.score(countedK, 0, count);
  }

  /** Collects k of the targets that count; returns their number. */
  private int collect(CoverableTargets observed) {
    if (countedK.length < observed.targets()) {
      countedK = new int[observed.targets()];
      coverable = new boolean[observed.targets()];
    }
    boolean all = !objective.countsCoverableOnly();
    if (!all) {
      observed.markCoverable(coverable);
    }
    int count = 0;
    for (int target = 0; target < observed.targets(); target++) {
      if (observed.present(target) && (all || coverable[target])) {
        countedK[count++] = observed.coverage(target);
      }
    }
    return count;
  }

  /** Measures the expected coverage of the last observation, for detections by chance. */
  public void expect(DetectionChances observed) {
    expected = expected == null ? new ExpectedCoverage() : expected;
    expected.measure(observed);
  }

  /** Whether detections are by chance, so that {@link #expected} is not null. */
  public boolean byChance() {
    return expected != null;
  }

  /** The expected coverage; null without chance. */
  public ExpectedCoverage expected() {
    return expected;
  }

  /** Returns 1 if k is below the limit, else 0; without a branch, which would be unpredictable. */
  private static int isBelow(int limit, int k) {
    return (k - limit) >>> 31;
  }

  /** The number of targets present. */
  public int targets() {
    return targets;
  }

  /** Returns k_min, the least number of cameras that cover a target (Eq 7.1). */
  public int kMin() {
    return least;
  }

  /** The score of the step by the objective; k_min by default. */
  public double score() {
    return score;
  }

  /** The number of targets that no camera covers. */
  public int covered0() {
    return uncovered;
  }

  /** The number of targets that exactly one camera covers. */
  public int covered1() {
    return coveredOnceAtMost - uncovered;
  }

  /** The number of targets that two or more cameras cover. */
  public int coveredK() {
    return targets - coveredOnceAtMost;
  }

  /** The sum of k_j over the targets: the number of detections in the network. */
  public long detections() {
    return sum;
  }

  /** The mean of k_j over the targets. */
  public double meanK() {
    return targets == 0 ? 0 : (double) sum / targets;
  }
}
