package org.hificamsim.solver.configuration;

import org.hificamsim.core.metrics.Objective;

/**
 * Bounds the score of a {@link CoverageProblem} without a search: {@link LocalSearch} makes a
 * configuration, and the bounds that {@link StepSolver} uses at the root of its search show what no
 * configuration exceeds. The gap between the two says how much better another configuration could
 * be at most.
 */
public final class BoundSolver extends Solver {
  private static final int LOCAL_PASSES = 4;
  private static final int PRICE_ROUNDS = 200;

  /** The number of parts of 1 to which gaps that are not whole numbers are rounded up. */
  private static final double GAP_FRACTIONS = 0x1p20;

  private final Objective objective;
  private final CoverageProblem problem;
  private final RemainingSets remaining;
  private final Stage stage;
  private final LocalSearch localSearch;
  private final Configuration best;
  private long value;
  private long bound;

  /**
   * @param objective the objective whose score is bounded; {@code lexicographic} is bounded only by
   *     the least k of the targets that can be covered
   * @param problem the problem, which each call of {@link #solve} reads
   */
  public BoundSolver(Objective objective, CoverageProblem problem) {
    this.objective = objective.countsCoverableOnly() ? Objective.kMin() : objective;
    this.problem = problem;
    remaining = new RemainingSets(problem);
    stage =
        objective.countsCoverableOnly()
            ? Stage.ofLeastCoverable(problem, remaining)
            : Stage.stages(objective, problem, remaining)[0];
    localSearch = new LocalSearch(problem, remaining, new Stage[] {stage});
    best = new Configuration(problem);
  }

  @Override
  public void solve() {
    best.reset();
    remaining.reset();
    stage.reset();
    bound = stage.bound();
    stage.require(bound);
    localSearch.improve(1, LOCAL_PASSES, best);
    value = stage.value(best.coverage());
    if (value < bound) {
      bound = objective.byLeast() ? leastBound() : sumBound();
    }
    proven = value == bound;
    gap = roundedUp(score(bound) - score(value));
  }

  /** Returns the greatest k before the first one that prices show to be out of reach. */
  private long leastBound() {
    for (long next = value + 1; next <= bound; next++) {
      stage.require(next);
      if (!stage.tunePrices(PRICE_ROUNDS)) {
        return next - 1;
      }
    }
    return bound;
  }

  private long sumBound() {
    stage.require(value + stage.step());
    return stage.tunePrices(PRICE_ROUNDS)
        ? Math.min(bound, stage.inUnits(stage.lowestPriceBound()) * stage.step())
        : value;
  }

  @Override
  public int chosen(int camera) {
    return best.set(camera);
  }

  /** Rounds up, so that sums of scores and gaps over many steps are bounds, too. */
  private static double roundedUp(double gap) {
    return gap == Math.rint(gap) ? gap : (Math.floor(gap * GAP_FRACTIONS) + 2) / GAP_FRACTIONS;
  }

  private double score(long stageValue) {
    return objective.scoreAtMost(stage.inUnits(stageValue), problem.targets());
  }
}
