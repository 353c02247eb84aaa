package org.hificamsim.network.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The area that two fields of view have in common. */
class FieldOfViewTest {
  private static final double ROUND = 2 * Math.PI;

  private static FieldOfView circle(double x, double y, double radius) {
    return new FieldOfView(x, y, 0, ROUND, radius);
  }

  @Test
  void circlesHaveALensInCommon() {
    double lens = 2 * Math.acos(0.5) - Math.sqrt(3) / 2;
    assertEquals(lens, circle(3, 4, 1).overlap(circle(3, 5, 1)), 1e-12);
    assertEquals(lens, circle(3, 4, 1).overlap(circle(2, 4, 1)), 1e-12);
  }

  @Test
  void aCircleInsideAnotherCountsInFull() {
    assertEquals(Math.PI, circle(0, 0, 5).overlap(circle(1, 1, 1)), 1e-12);
    assertEquals(Math.PI, circle(1, 1, 1).overlap(circle(0, 0, 5)), 1e-12);
  }

  @Test
  void aFieldOfViewOverlapsItselfInFull() {
    assertEquals(Math.PI * 4, circle(1, 2, 2).overlap(circle(1, 2, 2)), 1e-12);
    FieldOfView sector = new FieldOfView(1, 2, 0.7, 1.2, 3);
    assertEquals(3 * 3 * 1.2 / 2, sector.overlap(sector), 1e-9);
  }

  @Test
  void sectorsBackToBackHaveNothingInCommon() {
    FieldOfView north = new FieldOfView(0, 0, 0, Math.PI, 4);
    FieldOfView south = new FieldOfView(0, 0, Math.PI, Math.PI, 4);
    assertEquals(0, north.overlap(south), 1e-9);
  }

  @ParameterizedTest
  @CsvSource({"5, 0, 2, 2", "0, 0, 0, 3", "0, 0, 0, 0"})
  void nothingInCommonIsNoArea(double x, double y, double first, double second) {
    assertEquals(0, circle(0, 0, first).overlap(circle(x, y, second)), 1e-12);
  }

  @Test
  void aHalfCircleCutsALensInHalf() {
    double lens = 2 * Math.acos(0.5) - Math.sqrt(3) / 2;
    FieldOfView upper = new FieldOfView(0, 0, 0, Math.PI, 1);
    assertEquals(lens / 2, upper.overlap(circle(1, 0, 1)), 1e-9);
  }

  @Test
  void randomPairsAgreeWithCountingPointsOfAGrid() {
    SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < 60; i++) {
      FieldOfView first = random(random);
      FieldOfView second = random(random);
      double area = first.overlap(second);
      assertEquals(counted(first, second), area, 0.15, () -> first + " and " + second);
      assertEquals(area, second.overlap(first), 1e-6, () -> first + " and " + second);
    }
  }

  private static FieldOfView random(SplittableRandom random) {
    return new FieldOfView(
        random.nextDouble(-3, 3),
        random.nextDouble(-3, 3),
        random.nextDouble(-7, 7),
        random.nextInt(3) == 0 ? ROUND : random.nextDouble(0.1, ROUND),
        random.nextDouble(0.5, 5));
  }

  private static double counted(FieldOfView first, FieldOfView second) {
    double cell = 0.025;
    int inside = 0;
    for (double x = -8 + cell / 2; x < 8; x += cell) {
      for (double y = -8 + cell / 2; y < 8; y += cell) {
        if (first.contains(x, y) && second.contains(x, y)) {
          inside++;
        }
      }
    }
    return inside * cell * cell;
  }
}
