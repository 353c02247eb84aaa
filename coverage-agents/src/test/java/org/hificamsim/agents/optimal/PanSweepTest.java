package org.hificamsim.agents.optimal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.AllocatedBytes;
import org.junit.jupiter.api.Test;

class PanSweepTest {
  private static final double CLOSE = 1e-9;

  @Test
  void hasAllThatAnyPanAngleHasAndNothingTwice() {
    SplittableRandom random = new SplittableRandom(1);
    int several = 0;
    for (int trial = 0; trial < 3_000; trial++) {
      double[] bearings = bearings(random, random.nextInt(9), trial % 3 == 0);
      double opening =
          Math.toRadians(
              trial % 2 == 0 ? 30 * (1 + random.nextInt(12)) : 1 + random.nextDouble(120));
      double from = random.nextDouble(-7, 7);
      double to = from + (trial % 5 == 0 ? 2 * Math.PI : random.nextDouble(2 * Math.PI));
      PanSweep sweep = new PanSweep(9);
      sweep.sweep(bearings, bearings.length, opening, from, to);
      assertSets(sweep, bearings, opening, from, to);
      several += sweep.count() > 2 ? 1 : 0;
    }
    assertTrue(several > 200, several + " with several sets");
  }

  private static void assertSets(
      PanSweep sweep, double[] bearings, double opening, double from, double to) {
    List<BitSet> sets = new ArrayList<>();
    for (int i = 0; i < sweep.count(); i++) {
      sets.add(BitSet.valueOf(new long[] {sweep.mask(i, 0)}));
      assertTrue(sweep.pan(i) >= from && sweep.pan(i) <= to, "within the range");
      BitSet seen = seen(bearings, opening / 2 + CLOSE, sweep.pan(i));
      assertEquals(sets.get(i), subset(sets.get(i), seen), "in sight at its pan angle");
    }
    for (BitSet set : sets) {
      assertEquals(1, sets.stream().filter(other -> subset(set, other).equals(set)).count());
    }
    for (int i = 0; i <= 500; i++) {
      assertFound(sets, seen(bearings, opening / 2 - CLOSE, from + (to - from) * i / 500));
    }
    for (double bearing : bearings) {
      for (int turn = -3; turn <= 3; turn++) {
        double end = bearing + opening / 2 + turn * 2 * Math.PI - 2 * CLOSE;
        if (end >= from && end <= to) {
          assertFound(sets, seen(bearings, opening / 2 - CLOSE, end));
        }
      }
    }
  }

  private static void assertFound(List<BitSet> sets, BitSet seen) {
    assertTrue(
        seen.isEmpty() || sets.stream().anyMatch(set -> subset(seen, set).equals(seen)),
        () -> seen + " is in none of " + sets);
  }

  private static BitSet subset(BitSet set, BitSet of) {
    BitSet both = (BitSet) set.clone();
    both.and(of);
    return both;
  }

  private static BitSet seen(double[] bearings, double half, double pan) {
    BitSet seen = new BitSet();
    for (int target = 0; target < bearings.length; target++) {
      seen.set(target, Math.abs(Math.IEEEremainder(bearings[target] - pan, 2 * Math.PI)) <= half);
    }
    return seen;
  }

  private static double[] bearings(SplittableRandom random, int count, boolean round) {
    return random
        .doubles(count, -10, 10)
        .map(angle -> round ? Math.toRadians(15 * Math.rint(Math.toDegrees(angle) / 15)) : angle)
        .toArray();
  }

  @Test
  void bordersBelongToTheSector() {
    PanSweep sweep = new PanSweep(2);
    sweep.sweep(new double[] {0.25, 0.75}, 2, 0.5, -1, 1);
    assertEquals(1, sweep.count());
    assertEquals(0b11, sweep.mask(0, 0));
    assertEquals(0.5, sweep.pan(0));
    sweep.sweep(new double[] {0.25, 0.7501}, 2, 0.5, -1, 1);
    assertEquals(2, sweep.count());
    sweep.sweep(new double[] {0.75}, 1, 0.5, -1, 0.5);
    assertEquals(1, sweep.count(), "in sight at the end of the range alone");
    sweep.sweep(new double[] {0.76}, 1, 0.5, -1, 0.5);
    assertEquals(0, sweep.count());
  }

  @Test
  void takesMoreTargetsThanOneWordHoldsAndAllocatesNothing() {
    double[] bearings = new double[100];
    for (int target = 0; target < 100; target++) {
      bearings[target] = target * 0.01;
    }
    PanSweep sweep = new PanSweep(100);
    sweep.sweep(bearings, 100, 0.9951, -4, 4 + 2 * Math.PI);
    assertEquals(1, sweep.count());
    assertEquals(-1, sweep.mask(0, 0));
    assertEquals((1L << 36) - 1, sweep.mask(0, 1));
    assertEquals(
        0,
        AllocatedBytes.fewest(
            () -> AllocatedBytes.by(() -> sweep.sweep(bearings, 100, 0.3, -1, 1))));
  }
}
