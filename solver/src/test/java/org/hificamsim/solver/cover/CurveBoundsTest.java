package org.hificamsim.solver.cover;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Compares the bounds for some prices with all plans of small random instances. */
class CurveBoundsTest {
  private static final int CASES = 200;
  private static final double[] PRICES = {1, 2, 3, 5, 8};
  private static final double MARGIN = 1e-6;

  @Test
  void noPlanIsWorthMoreThanBoundForItsPrice() {
    SplittableRandom random = new SplittableRandom(21);
    double sumOfGaps = 0;
    for (int i = 0; i < CASES; i++) {
      CoverInstance instance =
          SmallInstances.random(random, 12, 9, i % 2 == 0).coverable().undominated();
      double[] best =
          Arrays.stream(PRICES)
              .map(price -> SmallInstances.best(instance, new Goal(price)))
              .toArray();
      double[] bounds = new CurveBounds(instance, instance.unitWorths()).bounds(PRICES, best);
      for (int plan = 0; plan < best.length; plan++) {
        assertTrue(bounds[plan] >= best[plan] - MARGIN, i + " " + plan);
        assertTrue(plan == 0 || bounds[plan - 1] <= bounds[plan], i + " " + plan);
        sumOfGaps += 1 - best[plan] / Math.max(MARGIN, bounds[plan]);
      }
    }
    double meanGap = sumOfGaps / CASES / PRICES.length;
    assertTrue(meanGap < 0.05, "" + meanGap);
  }

  @Test
  void boundsTwoCamerasByWhatTwoCover() {
    int[][] covered = {{0, 1}, {2, 3}, {4, 5}, {6, 7}};
    CoverInstance instance = CoverInstance.of(8, covered, new double[] {1, 1, 1, 1});
    double[] bounds =
        new CurveBounds(instance, instance.unitWorths())
            .bounds(new double[] {1, 2, 3, 4}, new double[] {2, 4, 6, 8});
    for (int plan = 0; plan < bounds.length; plan++) {
      assertEquals(2 * (plan + 1), bounds[plan], MARGIN);
    }
  }
}
