package org.hificamsim.solver.cover;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Compares cheaper plans with the plans that they replace. */
class CheaperPlanTest {
  private static final int CASES = 200;
  private static final Effort EFFORT = Effort.searchOnly(1, 30, () -> false);

  private static int[] cheaper(CoverInstance instance, int[] plan) {
    return CheaperPlan.find(instance, plan, Double.POSITIVE_INFINITY, EFFORT);
  }

  private static int[] solve(CoverInstance instance, Goal goal) {
    return CoverSearch.solve(instance, goal, EFFORT, (score, bound) -> {}).chosen();
  }

  @Test
  void cheaperPlanCoversAsMuchAndCostsNoMore() {
    SplittableRandom random = new SplittableRandom(11);
    int cheaperPlans = 0;
    for (int i = 0; i < CASES; i++) {
      CoverInstance instance = SmallInstances.random(random, 12, 9, i % 2 == 0);
      int[] plan = solve(instance, new Goal(1 + random.nextInt(20)));
      int[] cheaper = cheaper(instance, plan);
      assertTrue(
          instance.worth(instance.counts(cheaper)) >= instance.worth(instance.counts(plan)),
          "" + i);
      assertTrue(instance.price(cheaper) <= instance.price(plan), "" + i);
      cheaperPlans += instance.price(cheaper) < instance.price(plan) ? 1 : 0;
    }
    assertTrue(cheaperPlans > 0);
  }

  @Test
  void planForLargeBudgetCostsNoMoreThanFullCover() {
    SplittableRandom random = new SplittableRandom(12);
    for (int i = 0; i < CASES; i++) {
      CoverInstance instance = SmallInstances.random(random, 12, 9, false).coverable();
      double all = Arrays.stream(instance.prices()).sum();
      int[] plan = cheaper(instance, solve(instance, new Goal(all)));
      int[] cover = solve(instance, Goal.FULL_COVER);
      assertEquals(instance.totalWorth(), instance.worth(instance.counts(plan)), 1e-9, "" + i);
      assertTrue(instance.price(plan) <= instance.price(cover) + 1e-9, "" + i);
    }
  }

  @Test
  void keepsPlanIfCheaperOneHasTooManyCameras() {
    int[][] covered = {{0, 1}, {0}, {1}};
    CoverInstance instance = CoverInstance.of(2, covered, new double[] {9, 1, 1});
    int[] plan = {0};
    assertArrayEquals(plan, CheaperPlan.find(instance, plan, 1, EFFORT));
    assertArrayEquals(new int[] {1, 2}, CheaperPlan.find(instance, plan, 2, EFFORT));
  }
}
