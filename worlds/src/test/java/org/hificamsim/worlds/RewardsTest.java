package org.hificamsim.worlds;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;
import org.junit.jupiter.api.Test;

class RewardsTest {
  private static final int STEPS = 200;

  private static Played played(String reward) {
    return new Played(
        Played.settings("cluster-random", reward, ActionKind.VIEW, 1_000, true), 1, 1, 4);
  }

  @Test
  void coverageAndKMinPayAllCamerasEqually() {
    try (Played coverage = played("coverage");
        Played kMin = played("kmin");
        Played score = played("score")) {
      for (int step = 0; step < STEPS; step++) {
        coverage.step(4);
        kMin.step(4);
        score.step(4);
        assertPaid(coverage.floats("measures", 0)[0], coverage);
        assertPaid(kMin.floats("measures", 0)[1], kMin);
        assertPaid(score.floats("measures", 0)[2], score);
      }
    }
  }

  private static void assertPaid(float expected, Played played) {
    for (float reward : played.floats("rewards", 0)) {
      assertEquals(expected, reward);
    }
  }

  /** A target is lost without a camera only if no other camera detects it. */
  @Test
  void differenceIsLossOfCoverageWithoutCamera() {
    try (Played played = played("difference")) {
      double paid = 0;
      double sumDetectedOnce = 0;
      for (int step = 0; step < STEPS; step++) {
        played.step(4);
        float[] rewards = played.floats("rewards", 0);
        NetworkView network = played.worlds().network(0);
        double detectedOnce = 0;
        for (int target = 0; target < network.targets(); target++) {
          detectedOnce += network.coverage(target) == 1 ? 1.0 / network.targets() : 0;
        }
        double sum = 0;
        for (float reward : rewards) {
          sum += reward;
        }
        assertEquals(detectedOnce, sum, 1e-5);
        paid += sum;
        sumDetectedOnce += detectedOnce;
      }
      assertEquals(sumDetectedOnce, paid, 1e-3);
      assertTrue(paid > 0);
    }
  }

  /** The changes of the count of detected targets add up to the count. */
  @Test
  void thesisRewardsChangeOfCount() {
    try (Played played = played("thesis")) {
      double[] sums = new double[14];
      for (int step = 0; step < STEPS; step++) {
        played.step(4);
        float[] rewards = played.floats("rewards", 0);
        for (int camera = 0; camera < sums.length; camera++) {
          sums[camera] += rewards[camera];
        }
      }
      double[] detected = new double[14];
      Arrays.setAll(detected, camera -> played.worlds().network(0).detected(camera));
      for (int camera = 0; camera < sums.length; camera++) {
        assertEquals(detected[camera], sums[camera], 0);
      }
      assertTrue(Arrays.stream(detected).sum() > 0);
    }
  }
}
