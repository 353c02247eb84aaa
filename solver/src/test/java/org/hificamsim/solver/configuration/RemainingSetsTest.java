package org.hificamsim.solver.configuration;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class RemainingSetsTest {
  @Test
  void countsCamerasThatCanAndThatMustCover() {
    RemainingSets remaining = remaining(3, new long[][] {{0b011, 0b010}, {0b110}, {0b001, 0b100}});
    assertArrayEquals(new int[] {2, 2, 2}, Arrays.copyOf(remaining.maxCoverage(), 3));
    assertArrayEquals(
        new int[] {0, 2, 1}, IntStream.range(0, 3).map(remaining::minCoverage).toArray());
    remaining.choose(4);
    assertArrayEquals(new int[] {1, 2, 2}, Arrays.copyOf(remaining.maxCoverage(), 3));
    assertArrayEquals(
        new int[] {0, 2, 2}, IntStream.range(0, 3).map(remaining::minCoverage).toArray());
    assertTrue(remaining.isUndecided(0, 0));
    assertFalse(remaining.isUndecided(0, 1));
  }

  @Test
  void removeReportsThatNoSetIsLeft() {
    RemainingSets remaining = remaining(1, new long[][] {{1, 0}});
    assertTrue(remaining.remove(0));
    assertFalse(remaining.isOpen(0));
    assertEquals(1, remaining.first(0));
    assertFalse(remaining.remove(1));
    remaining.undo(0);
    assertTrue(remaining.isOpen(0));
    assertEquals(1, remaining.maxCoverage(0));
  }

  @Test
  void removesIncludedSetsAndKeepsFirstOfEqualOnes() {
    RemainingSets remaining =
        remaining(3, new long[][] {{0b001, 0b011, 0b011, 0b100}, {0b010}, {0b111, 0b101}});
    remaining.removeIncluded();
    assertArrayEquals(new int[] {1, 3}, remaining.sets(0));
    assertArrayEquals(new int[] {4}, remaining.sets(1));
    assertArrayEquals(new int[] {5}, remaining.sets(2));
  }

  @Test
  void undoRestoresAllCounts() {
    SplittableRandom random = new SplittableRandom(1);
    for (int trial = 0; trial < 2_000; trial++) {
      boolean[][][] sets = Problems.random(random, 6, 4, 70, 0.5);
      RemainingSets changed = new RemainingSets(Problems.problem(70, sets));
      changed.reset();
      changed.remove(random.nextInt(sets[0].length));
      int mark = changed.mark();
      String before = text(changed, sets);
      for (int change = 0; change < 6; change++) {
        change(changed, random, sets);
      }
      changed.undo(mark);
      assertEquals(before, text(changed, sets));
    }
  }

  private static void change(RemainingSets changed, SplittableRandom random, boolean[][][] sets) {
    int camera = random.nextInt(sets.length);
    if (changed.setCount(camera) > 0) {
      int[] left = changed.sets(camera);
      int set = left[random.nextInt(left.length)];
      if (random.nextBoolean()) {
        changed.remove(set);
      } else {
        changed.choose(set);
      }
    }
  }

  private static String text(RemainingSets remaining, boolean[][][] sets) {
    StringBuilder text = new StringBuilder();
    text.append(Arrays.toString(remaining.maxCoverage()));
    IntStream.range(0, 70)
        .forEach(target -> text.append(remaining.minCoverage(target)).append(' '));
    for (int camera = 0; camera < sets.length; camera++) {
      text.append(Arrays.toString(remaining.sets(camera)))
          .append(remaining.setCount(camera))
          .append(remaining.undecided(camera, 0))
          .append(remaining.undecided(camera, 1));
    }
    return text.toString();
  }

  private static RemainingSets remaining(int targets, long[][] masks) {
    RemainingSets remaining =
        new RemainingSets(Problems.problem(targets, Problems.of(targets, masks)));
    remaining.reset();
    return remaining;
  }
}
