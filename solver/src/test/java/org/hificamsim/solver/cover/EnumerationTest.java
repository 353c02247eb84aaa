package org.hificamsim.solver.cover;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Compares the enumeration with all plans of small instances. */
class EnumerationTest {
  private static final int CASES = 200;

  private static ExactMethod.Result solve(CoverInstance instance, int cameras, int[] start) {
    return new Enumeration()
        .solve(instance, new Goal(cameras), start, instance.totalWorth(), () -> false);
  }

  @Test
  void bestOfAllPlansIsProvenFromAnyStart() {
    SplittableRandom random = new SplittableRandom(21);
    for (int i = 0; i < CASES; i++) {
      CoverInstance instance = SmallInstances.random(random, 14, 10, true);
      int cameras = 1 + i % 6;
      assertTrue(Enumeration.suits(instance, new Goal(cameras)));
      double best = SmallInstances.best(instance, new Goal(cameras));
      int[] start = i % 2 == 0 ? new int[0] : new int[] {random.nextInt(10)};
      ExactMethod.Result found = solve(instance, cameras, start);
      assertEquals(best, instance.worth(instance.counts(found.chosen())), 1e-9, "" + i);
      assertEquals(best, found.bound(), 1e-9, "" + i);
      assertTrue(found.chosen().length <= cameras);
    }
  }

  @Test
  void bestFourOfFortyCamerasAreProven() {
    SplittableRandom random = new SplittableRandom(4);
    CoverInstance instance = SmallInstances.random(random, 150, 40, true);
    double best = 0;
    for (int a = 0; a < 40; a++) {
      for (int b = a + 1; b < 40; b++) {
        for (int c = b + 1; c < 40; c++) {
          for (int d = c + 1; d < 40; d++) {
            best = Math.max(best, instance.worth(instance.counts(new int[] {a, b, c, d})));
          }
        }
      }
    }
    ExactMethod.Result found = solve(instance, 4, new int[] {1, 2, 3, 4});
    assertEquals(best, found.bound(), 1e-9);
    assertEquals(best, instance.worth(instance.counts(found.chosen())), 1e-9);
    assertArrayEquals(found.chosen(), solve(instance, 4, new int[] {1, 2, 3, 4}).chosen());
  }

  @Test
  void stoppedEnumerationReturnsPlanAndBoundThatItWasGiven() {
    CoverInstance instance = SmallInstances.random(new SplittableRandom(4), 150, 40, true);
    int[] start = {1, 2};
    ExactMethod.Result found =
        new Enumeration().solve(instance, new Goal(4), start, 140, () -> true);
    assertArrayEquals(start, found.chosen());
    assertEquals(140, found.bound());
  }

  @Test
  void planWithLooseMultiplierBoundIsProvenByEnumeration() {
    CoverInstance instance = SmallInstances.random(new SplittableRandom(4), 150, 40, true);
    ExactMethod unused =
        (part, goal, start, bound, stop) -> {
          throw new AssertionError();
        };
    Effort.Limits noLimits = new Effort.Limits(() -> false, () -> false, () -> false, () -> false);
    Effort effort = new Effort(1, 5, Optional.of(unused), noLimits);
    CoverPlan plan = CoverSearch.solve(instance, new Goal(4), effort, (score, bound) -> {});
    assertTrue(plan.isProven() && plan.multiplierBound().value() > 1.03 * plan.score());
  }

  @Test
  void enumerationSuitsEqualPointsWithEqualPricesOnly() {
    SplittableRandom random = new SplittableRandom(4);
    CoverInstance equal = SmallInstances.random(random, 20, 10, true);
    assertFalse(Enumeration.suits(equal, Goal.FULL_COVER));
    assertFalse(Enumeration.suits(equal, new Goal(7)));
    assertFalse(Enumeration.suits(SmallInstances.random(random, 20, 10, false), new Goal(3)));
  }
}
