package org.hificamsim.solver.cover;

import java.util.Arrays;
import java.util.function.BooleanSupplier;

/**
 * Proves plans of few cameras, for which linear bounds are of little use, by a search of all plans
 * that could be better. It solves problems whose points have equal worth and count once, and whose
 * candidates have equal prices. The search first proves that no plan is better by 1 %, and then
 * that none is better at all.
 */
final class Enumeration implements ExactMethod {
  private static final double[] MARGINS = {0.01, 0};
  private static final int MAX_CAMERAS = 6;

  /** Whether the method can solve a problem. */
  static boolean suits(CoverInstance instance, Goal goal) {
    double firstPrice = instance.prices()[0];
    return !goal.isFullCover()
        && goal.scoreStep(instance) > 0
        && Arrays.stream(instance.prices()).allMatch(price -> price == firstPrice)
        && goal.budget() < (MAX_CAMERAS + 1) * firstPrice
        && Arrays.stream(instance.needs()).allMatch(needed -> needed <= 1);
  }

  @Override
  public Result solve(
      CoverInstance instance, Goal goal, int[] start, double bound, BooleanSupplier stop) {
    int cameras = (int) (goal.budget() / instance.prices()[0] + 1e-9);
    EnumerationTree tree = new EnumerationTree(instance, start, cameras, stop);
    double leastBound = bound;
    for (double margin : MARGINS) {
      double coveredBound = tree.search(margin);
      leastBound = Math.min(leastBound, goal.scoreStep(instance) * coveredBound);
    }
    return new Result(tree.best(), leastBound);
  }
}
