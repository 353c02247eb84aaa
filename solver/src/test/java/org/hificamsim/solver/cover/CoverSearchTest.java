package org.hificamsim.solver.cover;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Compares plans and bounds with all plans of small random instances. */
class CoverSearchTest {
  private static final int CASES = 300;

  private static CoverPlan solve(CoverInstance instance, Goal goal) {
    return CoverSearch.solve(
        instance, goal, Effort.searchOnly(1, 30, () -> false), (score, bound) -> {});
  }

  @Test
  void findsBestPlansAndValidBounds() {
    SplittableRandom random = new SplittableRandom(7);
    int found = 0;
    for (int i = 0; i < CASES; i++) {
      CoverInstance instance = SmallInstances.random(random, 12, 9, i % 2 == 0).coverable();
      Goal goal = i % 3 == 0 ? Goal.FULL_COVER : new Goal(1 + random.nextInt(6));
      double best = SmallInstances.best(instance, goal);
      CoverPlan plan = solve(instance, goal);
      double margin = 1e-6;
      assertTrue(
          goal.isFullCover() ? plan.bound() <= best + margin : plan.bound() >= best - margin,
          "" + i);
      assertTrue(
          goal.isFullCover() ? plan.score() >= best - margin : plan.score() <= best + margin,
          "" + i);
      assertEquals(goal.score(instance, plan.chosen()), plan.score(), margin);
      CoverPlan.MultiplierBound multiplierBound = plan.multiplierBound();
      double value =
          LagrangianBound.value(instance.undominated(), goal, multiplierBound.multipliers());
      assertEquals(multiplierBound.value(), value, margin, "" + i);
      found += Math.abs(best - plan.score()) < margin ? 1 : 0;
    }
    assertTrue(found >= CASES * 0.98, found + " of " + CASES);
  }

  @Test
  void searchOfSameSeedFindsSamePlan() {
    CoverInstance instance = SmallInstances.random(new SplittableRandom(3), 200, 150, false);
    CoverPlan plan = solve(instance, new Goal(12));
    assertArrayEquals(plan.chosen(), solve(instance, new Goal(12)).chosen());
    assertTrue(plan.gap() < 0.1, "" + plan.gap());
  }

  @Test
  void candidateIsDominatedByAsManyOthersAsPointsNeed() {
    int[][] covered = {{0, 1}, {0}, {0, 1}, {}, {1, 2}};
    CoverInstance once = CoverInstance.of(3, covered, new double[] {1, 1, 1, 1, 1});
    assertArrayEquals(new int[] {0, 4}, Dominance.undominated(once));
    int[] needs = {2, 2, 2};
    CoverInstance twice = new CoverInstance(once.unitWorths(), needs, covered, once.prices());
    assertArrayEquals(new int[] {0, 2, 4}, Dominance.undominated(twice));
  }

  @Test
  void searchThatIsStoppedAtOnceHasAPlan() {
    CoverInstance instance =
        SmallInstances.random(new SplittableRandom(5), 50, 40, true).coverable();
    CoverPlan plan =
        CoverSearch.solve(
            instance, Goal.FULL_COVER, Effort.searchOnly(1, 9, () -> true), (score, bound) -> {});
    int[] counts = instance.counts(plan.chosen());
    assertTrue(instance.isFullyCovered(counts));
    assertTrue(Arrays.stream(plan.chosen()).count() > 0);
  }
}
