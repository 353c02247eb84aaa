package org.hificamsim.core.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import java.util.function.DoubleSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ArcCosineTest {
  private static final int DRAWS = 1_000_000;

  private final SplittableRandom random = new SplittableRandom(7);

  @ParameterizedTest
  @ValueSource(
      doubles = {
        0,
        0x1p-57,
        0x1p-27,
        0.5,
        0.7071067811865476,
        1,
        2,
        Double.MIN_NORMAL,
        Double.MAX_VALUE,
        Double.POSITIVE_INFINITY,
        Double.NaN
      })
  void equalsStrictMathAroundBorders(double border) {
    double below = border;
    double above = border;
    for (int i = 0; i < 10_000; i++) {
      requireEqual(below);
      requireEqual(-below);
      requireEqual(above);
      requireEqual(-above);
      below = Math.nextDown(below);
      above = Math.nextUp(above);
    }
  }

  @Test
  void equalsStrictMathForCosines() {
    requireEqual(() -> random.nextDouble(-1, 1));
  }

  @Test
  void equalsStrictMathForAnyExponent() {
    requireEqual(() -> Math.scalb(random.nextDouble(-1, 1), -random.nextInt(80)));
    requireEqual(() -> Double.longBitsToDouble(random.nextLong()));
  }

  @Test
  void equalsStrictMathNearOneAndHalf() {
    requireEqual(() -> 1 - Math.scalb(random.nextDouble(), -random.nextInt(54)));
    requireEqual(() -> Math.scalb(random.nextDouble(), -random.nextInt(54)) - 1);
    requireEqual(() -> 0.5 + Math.scalb(random.nextDouble(-1, 1), -random.nextInt(54)));
    requireEqual(() -> Math.scalb(random.nextDouble(-1, 1), -random.nextInt(54)) - 0.5);
  }

  private static void requireEqual(DoubleSupplier cosines) {
    for (int i = 0; i < DRAWS; i++) {
      requireEqual(cosines.getAsDouble());
    }
  }

  private static void requireEqual(double cosine) {
    assertEquals(StrictMath.acos(cosine), ArcCosine.of(cosine), () -> "arc cosine of " + cosine);
  }
}
