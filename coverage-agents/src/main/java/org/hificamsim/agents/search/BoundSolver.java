package org.hificamsim.agents.search;

import org.hificamsim.core.metrics.Objective;

/**
 * Bounds what a {@link CoverageProblem} may score, without a search: {@link LocalSearch} makes a
 * configuration, and prices of coverage, as at the root of {@link StepSolver}'s search, show what
 * no other exceeds. The gap between the two is what the configuration is not proven to be the best
 * by.
 */
public final class BoundSolver extends Solver {
  private static final int PASSES = 4;
  private static final int ROUNDS = 200;

  /** Parts of a score: where it is no whole number, gaps are rounded up to the next but one. */
  private static final double PARTS = 0x1p20;

  private final Objective objective;
  private final CoverageProblem problem;
  private final RemainingSets remaining;
  private final Stage stage;
  private final LocalSearch local;
  private final Configuration best;
  private long value;
  private long bound;

  /**
   * @param objective whose score is bounded; not the finer order that lexicographic compares by
   * @param problem what each call of {@link #solve} reads
   */
  public BoundSolver(Objective objective, CoverageProblem problem) {
    this.objective = objective.ofCoverableAlone() ? Objective.kMin() : objective;
    this.problem = problem;
    remaining = new RemainingSets(problem);
    Stage[] stages = StepSolver.stages(this.objective, problem, remaining);
    stage = stages[0];
    if (objective.ofCoverableAlone()) {
      stage.countCoverableAlone();
    }
    local = new LocalSearch(problem, remaining, stages);
    best = new Configuration(problem);
  }

  @Override
  public void solve() {
    best.reset();
    remaining.reset();
    stage.reset();
    bound = stage.bound();
    stage.require(bound);
    local.reach(1, PASSES, best);
    value = stage.value(best.coverage());
    if (value < bound) {
      bound = objective.byLeast() ? leastBound() : sumBound();
    }
    proven = value == bound;
    gap = roundedUp(score(bound) - score(value));
  }

  /** The last k before the first that prices show to be out of reach. */
  private long leastBound() {
    for (long next = value + 1; next <= bound; next++) {
      stage.require(next);
      if (!stage.tune(ROUNDS)) {
        return next - 1;
      }
    }
    return bound;
  }

  private long sumBound() {
    stage.require(value + stage.step());
    return stage.tune(ROUNDS)
        ? Math.min(bound, stage.inUnits(stage.tightest()) * stage.step())
        : value;
  }

  @Override
  public int chosen(int camera) {
    return best.of(camera);
  }

  /** Rounded up: also summed over many steps, the score and its gap are a bound. */
  private static double roundedUp(double gap) {
    return gap == Math.rint(gap) ? gap : (Math.floor(gap * PARTS) + 2) / PARTS;
  }

  private double score(long ofValue) {
    return objective.scoreAtMost(stage.inUnits(ofValue), problem.targets());
  }
}
