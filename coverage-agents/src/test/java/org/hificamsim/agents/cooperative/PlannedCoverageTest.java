package org.hificamsim.agents.cooperative;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import org.hificamsim.core.metrics.Objective;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PlannedCoverageTest {
  @Test
  void furtherCameraAddsWhatOthersMiss() {
    PlannedCoverage coverage = coverage("covered:k=1");
    coverage.add(0, 0.5);
    coverage.add(0, 0.2);
    assertEquals(0.5 * 0.8, coverage.added(0), 1e-12);
    assertEquals(1, coverage.added(1), 1e-12);
  }

  @Test
  void certainCameraLeavesNothingToAdd() {
    PlannedCoverage coverage = coverage("covered:k=1");
    coverage.add(0, 0.5);
    coverage.add(0, 1);
    assertEquals(0, coverage.added(0), 1e-12);
    coverage.remove(0, 1);
    assertEquals(0.5, coverage.added(0), 1e-12);
  }

  @Test
  void firstOfTwoNeededCamerasAddsAPartOfTheWorth() {
    PlannedCoverage coverage = coverage("covered:k=2");
    assertEquals(0.2, coverage.added(0), 1e-12);
    coverage.add(0, 1);
    assertEquals(0.8, coverage.added(0), 1e-12);
    coverage.add(0, 1);
    assertEquals(0, coverage.added(0), 1e-12);
  }

  @ParameterizedTest
  @ValueSource(strings = {"kmin", "lexicographic"})
  void eachFurtherCameraIsWorthHalfIfTheLeastKCounts(String objective) {
    PlannedCoverage coverage = coverage(objective);
    for (double expected : new double[] {1, 0.5, 0.25, 0.125, 0}) {
      assertEquals(expected, coverage.added(0), 1e-12);
      coverage.add(0, 1);
    }
  }

  /** Compares with the sum over all combinations of cameras that detect the target. */
  @Test
  void equalsTheSumOverAllOutcomes() {
    SplittableRandom random = new SplittableRandom(3);
    Worth worth = new Worth(Objective.parse("sum:cap=3"), 0.2, 0.5);
    for (int trial = 0; trial < 100; trial++) {
      PlannedCoverage coverage = new PlannedCoverage(worth);
      coverage.clear(1);
      double[] chances = new double[5];
      for (int camera = 0; camera < chances.length; camera++) {
        chances[camera] = random.nextInt(3) == 0 ? 1 : random.nextDouble();
        coverage.add(0, chances[camera]);
      }
      double last = chances[4] > 0.98 ? 1 : chances[4];
      coverage.remove(0, last);
      assertEquals(expectedOverOutcomes(worth, chances, 4), coverage.added(0), 0.05);
    }
  }

  private static double expectedOverOutcomes(Worth worth, double[] chances, int cameras) {
    double sum = 0;
    for (int outcome = 0; outcome < 1 << cameras; outcome++) {
      double chance = 1;
      for (int camera = 0; camera < cameras; camera++) {
        boolean detects = (outcome >> camera & 1) == 1;
        chance *= detects ? chances[camera] : 1 - chances[camera];
      }
      int k = Integer.bitCount(outcome);
      sum += k < worth.saturation() ? chance * worth.added(k) : 0;
    }
    return sum;
  }

  private static PlannedCoverage coverage(String objective) {
    PlannedCoverage coverage = new PlannedCoverage(new Worth(Objective.parse(objective), 0.2, 0.5));
    coverage.clear(2);
    return coverage;
  }
}
