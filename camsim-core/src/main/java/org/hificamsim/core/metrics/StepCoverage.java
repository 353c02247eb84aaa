package org.hificamsim.core.metrics;

/**
 * How the targets present are covered in one step (thesis 7.1, Eq 7.1), and how the step is scored;
 * measured again each step.
 *
 * <p>Without any target everything is 0.
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
  private int[] counting = {};
  private boolean[] coverable = {};

  /** Scored by k_min. */
  public StepCoverage() {
    this(Objective.kMin());
  }

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

  /** Measures what the objective makes of the last observation; after {@link #measure}. */
  public void measureScore(CoverableTargets observed) {
    int count = collect(observed);
    score = objective.score(counting, 0, count);
  }

  /** Collects k of the targets that count; returns how many there are. */
  private int collect(CoverableTargets observed) {
    if (counting.length < observed.targets()) {
      counting = new int[observed.targets()];
      coverable = new boolean[observed.targets()];
    }
    boolean all = !objective.ofCoverableAlone();
    if (!all) {
      observed.markCoverable(coverable);
    }
    int count = 0;
    for (int target = 0; target < observed.targets(); target++) {
      if (observed.present(target) && (all || coverable[target])) {
        counting[count++] = observed.coverage(target);
      }
    }
    return count;
  }

  /** Measures what was to be expected of the last observation, where detections are by chance. */
  public void expect(DetectionChances observed) {
    expected = expected == null ? new ExpectedCoverage() : expected;
    expected.measure(observed);
  }

  /** Whether detections are by chance: {@link #expected} has an answer. */
  public boolean byChance() {
    return expected != null;
  }

  /** The coverage that was to be expected; null where nothing is left to chance. */
  public ExpectedCoverage expected() {
    return expected;
  }

  /** 1 or 0, by the sign of a difference: a branch would be guessed wrong too often. */
  private static int isBelow(int limit, int k) {
    return (k - limit) >>> 31;
  }

  /** The number of targets present. */
  public int targets() {
    return targets;
  }

  /** k_min, the least number of cameras that cover a target (Eq 7.1). */
  public int kMin() {
    return least;
  }

  /** What the objective makes of the step; k_min by default. */
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
