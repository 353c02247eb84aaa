package org.hificamsim.core.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class LuckTest {
  private static final int BINS = 100;

  /** The number that chi-square with 99 degrees of freedom exceeds once in a thousand times. */
  private static final double LIMIT = 148;

  /** A million draws: over steps of one pair, over pairs of one step, over seeds. */
  @ParameterizedTest
  @CsvSource({"1000000, 1, 1, 1", "1, 1000, 1000, 1", "1, 1, 1, 1000000", "100, 100, 100, 1"})
  void isUniform(int steps, int cameras, int targets, int seeds) {
    int[] counts = new int[BINS];
    for (int seed = 0; seed < seeds; seed++) {
      Luck luck = new Luck(seed, 1);
      for (int step = 0; step < steps; step++) {
        for (int camera = 0; camera < cameras; camera++) {
          for (int target = 0; target < targets; target++) {
            counts[(int) (luck.draw(step, camera, target) * BINS)]++;
          }
        }
      }
    }
    assertTrue(chiSquare(counts, 1e6 / BINS) < LIMIT, "chi-square " + chiSquare(counts, 1e4));
  }

  /** Draws of neighbouring steps, cameras, targets and seeds are independent. */
  @ParameterizedTest
  @CsvSource({"1, 0, 0, 0", "0, 1, 0, 0", "0, 0, 1, 0", "0, 0, 0, 1", "1, 1, 0, 0", "0, 1, -1, 0"})
  void neighboursAreIndependent(int step, int camera, int target, int seed) {
    int[] counts = new int[BINS];
    for (int i = 0; i < 1_000_000; i++) {
      int a = i % 100;
      int b = i / 100 % 100;
      int c = 1 + i / 10_000;
      double first = new Luck(7, 1).draw(a, b, c);
      double second = new Luck(7 + seed, 1).draw(a + step, b + camera, c + target);
      counts[((int) (first * 10)) * 10 + (int) (second * 10)]++;
    }
    assertTrue(chiSquare(counts, 1e4) < LIMIT, "chi-square " + chiSquare(counts, 1e4));
  }

  /** Computed independently with Python's integers; recorded runs depend on these numbers. */
  @ParameterizedTest
  @CsvSource({
    "0, 1, 0, 0, 0, 0.33805245419550545",
    "42, 1, 3, 1, 2, 0.4214569957962143",
    "42, 1, 3, 1, -1, 0.3610201173645198",
    "-1, 10, 7, 5, 9, 0.5601630368902141",
  })
  void equalsRecordedDraws(long seed, int memory, long step, int camera, int target, double drawn) {
    assertEquals(drawn, new Luck(seed, memory).draw(step, camera, target));
  }

  @Test
  void dependsOnlyOnSeedStepCameraAndTarget() {
    Luck luck = new Luck(42, 1);
    double first = luck.draw(3, 1, 2);
    luck.draw(9, 9, 9);
    assertEquals(first, luck.draw(3, 1, 2));
    assertEquals(first, new Luck(42, 1).draw(3, 1, 2));
    assertNotEquals(first, new Luck(43, 1).draw(3, 1, 2));
    assertNotEquals(first, luck.draw(3, 2, 1));
    assertNotEquals(first, luck.draw(3, 1, -1));
  }

  @ParameterizedTest
  @ValueSource(ints = {2, 7, 100})
  void memoryKeepsDrawForGivenSteps(int memory) {
    Luck luck = new Luck(5, memory);
    int steps = 1000 * memory;
    int changes = 0;
    int firstChange = -1;
    for (int step = 1; step < steps; step++) {
      if (luck.draw(step, 0, 0) != luck.draw(step - 1, 0, 0)) {
        firstChange = firstChange < 0 ? step : firstChange;
        assertEquals(firstChange % memory, step % memory, "all at the same distance");
        changes++;
      }
    }
    assertTrue(changes == 999 || changes == 1000, changes + " changes");
  }

  @Test
  void pairsRedrawAtDifferentSteps() {
    Luck luck = new Luck(5, 50);
    int[] changes = new int[50];
    for (int target = 0; target < 5000; target++) {
      for (int step = 1; step <= 50; step++) {
        if (luck.draw(step, 0, target) != luck.draw(step - 1, 0, target)) {
          changes[step - 1]++;
        }
      }
    }
    assertTrue(chiSquare(changes, 100) < 85.4, "chi-square of 49 degrees, once in a thousand");
  }

  private static double chiSquare(int[] counts, double expected) {
    double sum = 0;
    for (int count : counts) {
      sum += (count - expected) * (count - expected) / expected;
    }
    return sum;
  }
}
