package org.hificamsim.solver.cover;

import java.util.Arrays;

/**
 * Replaces a plan by a cheaper one that covers every point at least as often, up to the number of
 * times that counts. A plan that covers the most for a budget may spend the rest of the budget on
 * nothing.
 */
public final class CheaperPlan {
  private CheaperPlan() {}

  /**
   * Returns the cheapest plan that is found.
   *
   * @param instance the instance, with the prices that are to be paid
   * @param plan the plan to be replaced
   * @param maxCameras the greatest number of cameras
   * @return a plan that is not more expensive, perhaps the same
   */
  public static int[] find(CoverInstance instance, int[] plan, double maxCameras, Effort effort) {
    if (!mayBeCheaper(instance, plan)) {
      return plan;
    }
    CoverInstance sameCover = instance.needingAtMost(instance.counts(plan));
    Effort search = Effort.searchOnly(effort.seed(), effort.idleRounds(), effort.limits().all());
    int[] found =
        CoverSearch.solve(sameCover, Goal.FULL_COVER, search, (score, bound) -> {}).chosen();
    boolean cheaper = instance.price(found) < instance.price(plan);
    return cheaper && found.length <= maxCameras ? found : plan;
  }

  /**
   * Whether prices differ, or everything is covered. Otherwise no plan can be cheaper, because all
   * cameras have one price and each camera of a good plan adds something.
   */
  private static boolean mayBeCheaper(CoverInstance instance, int[] plan) {
    boolean pricesDiffer = Arrays.stream(instance.prices()).distinct().count() > 1;
    return pricesDiffer || instance.coverable().isFullyCovered(instance.counts(plan));
  }
}
