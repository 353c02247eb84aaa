package org.hificamsim.placement.cover;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Search and bounds beside all plans of small random instances. */
class CoverSearchTest {
  private static final int CASES = 300;

  private static CoverPlan solve(CoverInstance instance, Goal goal) {
    return CoverSearch.solve(instance, goal, Effort.of(1, 30, () -> false), (score, bound) -> {});
  }

  @Test
  void findsTheBestPlanOfSmallInstancesAndNeverProvesMoreThanThereIs() {
    SplittableRandom random = new SplittableRandom(7);
    int found = 0;
    for (int i = 0; i < CASES; i++) {
      CoverInstance instance = SmallInstances.random(random, 12, 9, i % 2 == 0).coverable();
      Goal goal = i % 3 == 0 ? Goal.ALL : new Goal(1 + random.nextInt(6));
      double best = SmallInstances.best(instance, goal);
      CoverPlan plan = solve(instance, goal);
      double margin = 1e-6;
      assertTrue(
          goal.isAll() ? plan.bound() <= best + margin : plan.bound() >= best - margin, "" + i);
      assertTrue(
          goal.isAll() ? plan.score() >= best - margin : plan.score() <= best + margin, "" + i);
      assertEquals(goal.score(instance, plan.chosen()), plan.score(), margin);
      CoverInstance left = instance.with(Dominance.left(instance));
      assertEquals(plan.relaxed(), Duals.value(left, goal, plan.proof()), margin, "" + i);
      found += Math.abs(best - plan.score()) < margin ? 1 : 0;
    }
    assertTrue(found >= CASES * 0.98, found + " of " + CASES);
  }

  @Test
  void givesTheSamePlanForTheSameSeed() {
    CoverInstance instance = SmallInstances.random(new SplittableRandom(3), 200, 150, false);
    CoverPlan plan = solve(instance, new Goal(12));
    assertArrayEquals(plan.chosen(), solve(instance, new Goal(12)).chosen());
    assertTrue(plan.gap() < 0.1, "" + plan.gap());
  }

  @Test
  void leavesOutWhatOthersDominateAsOftenAsSamplesCount() {
    int[][] columns = {{0, 1}, {0}, {0, 1}, {}, {1, 2}};
    CoverInstance once = CoverInstance.of(3, columns, new double[] {1, 1, 1, 1, 1});
    assertArrayEquals(new int[] {0, 4}, Dominance.left(once));
    int[] twice = {2, 2, 2};
    CoverInstance more = new CoverInstance(once.units(), twice, columns, once.prices());
    assertArrayEquals(new int[] {0, 2, 4}, Dominance.left(more));
  }

  @Test
  void hasAPlanWhenItIsStoppedAtOnce() {
    CoverInstance instance =
        SmallInstances.random(new SplittableRandom(5), 50, 40, true).coverable();
    CoverPlan plan =
        CoverSearch.solve(instance, Goal.ALL, Effort.of(1, 9, () -> true), (score, bound) -> {});
    int[] counts = instance.counts(plan.chosen());
    assertTrue(IntStream.range(0, 50).allMatch(s -> counts[s] >= instance.needs()[s]));
    assertTrue(Arrays.stream(plan.chosen()).count() > 0);
  }
}
