package org.hificamsim.core.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;

class StepCoverageTest {
  /** Takes a coverage per target; -1 for an absent target. */
  @Property
  void equalsDirectCounts(
      @ForAll @Size(max = 12) List<@IntRange(min = -1, max = 4) Integer> coverage) {
    StepCoverage measured = measure(coverage.stream().mapToInt(k -> k).toArray());
    int[] present = coverage.stream().mapToInt(k -> k).filter(k -> k >= 0).toArray();
    assertEquals(present.length, measured.targets());
    assertEquals(Arrays.stream(present).min().orElse(0), measured.kMin());
    assertEquals(count(present, 0, 0), measured.covered0());
    assertEquals(count(present, 1, 1), measured.covered1());
    assertEquals(count(present, 2, 99), measured.coveredK());
    assertEquals(Arrays.stream(present).sum(), measured.detections());
    assertEquals(Arrays.stream(present).average().orElse(0), measured.meanK());
    assertEquals(
        measured.targets(), measured.covered0() + measured.covered1() + measured.coveredK());
  }

  @Test
  void isZeroWithoutTargets() {
    for (StepCoverage measured : List.of(measure(), measure(-1, -1), new StepCoverage())) {
      assertEquals(0, measured.targets());
      assertEquals(0, measured.kMin());
      assertEquals(0, measured.covered0());
      assertEquals(0, measured.covered1());
      assertEquals(0, measured.coveredK());
      assertEquals(0, measured.meanK());
    }
  }

  @Test
  void measureForgetsLastStep() {
    StepCoverage coverage = measure(0, 1, 2, 3);
    coverage.measure(targets(4, 4));
    assertEquals(2, coverage.targets());
    assertEquals(4, coverage.kMin());
    assertEquals(0, coverage.covered0());
    assertEquals(0, coverage.covered1());
    assertEquals(2, coverage.coveredK());
    assertEquals(4, coverage.meanK());
  }

  private static long count(int[] values, int least, int most) {
    return Arrays.stream(values).filter(k -> k >= least && k <= most).count();
  }

  private static StepCoverage measure(int... coverage) {
    StepCoverage measured = new StepCoverage();
    measured.measure(targets(coverage));
    return measured;
  }

  private static CoveredTargets targets(int... coverage) {
    return new CoveredTargets() {
      @Override
      public int targets() {
        return coverage.length;
      }

      @Override
      public boolean present(int target) {
        return coverage[target] >= 0;
      }

      @Override
      public int coverage(int target) {
        return coverage[target];
      }
    };
  }
}
