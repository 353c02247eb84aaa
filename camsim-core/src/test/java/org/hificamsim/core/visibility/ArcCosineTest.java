package org.hificamsim.core.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import java.util.function.DoubleSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** To the bit what Java says. */
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
        Double.MIN_VALUE,
        Double.MIN_NORMAL,
        Double.MAX_VALUE,
        Double.POSITIVE_INFINITY,
        Double.NaN
      })
  void isJavasAtBordersAndBesideThem(double border) {
    double below = border;
    double above = border;
    for (int i = 0; i < 10_000; i++) {
      assertJavas(below);
      assertJavas(-below);
      assertJavas(above);
      assertJavas(-above);
      below = Math.nextDown(below);
      above = Math.nextUp(above);
    }
  }

  @Test
  void isJavasOfCosinesOfAnySize() {
    assertJavas(() -> random.nextDouble(-1, 1));
  }

  @Test
  void isJavasWhateverTheExponent() {
    assertJavas(() -> Math.scalb(random.nextDouble(-1, 1), -random.nextInt(80)));
    assertJavas(() -> Double.longBitsToDouble(random.nextLong()));
  }

  @Test
  void isJavasAsNearToOneAndToAHalfAsMayBe() {
    assertJavas(() -> 1 - Math.scalb(random.nextDouble(), -random.nextInt(54)));
    assertJavas(() -> Math.scalb(random.nextDouble(), -random.nextInt(54)) - 1);
    assertJavas(() -> 0.5 + Math.scalb(random.nextDouble(-1, 1), -random.nextInt(54)));
    assertJavas(() -> Math.scalb(random.nextDouble(-1, 1), -random.nextInt(54)) - 0.5);
  }

  @Test
  void isJavasOfWhatACameraSees() {
    Pose camera = Pose.of(3, -2, 1);
    assertJavas(() -> camera.cosine(random.nextDouble(-20, 20), random.nextDouble(-20, 20)));
    for (int along = -100; along <= 100; along++) { // straight behind and ahead
      assertJavas(camera.cosine(3 + along * camera.headingX(), -2 + along * camera.headingY()));
    }
  }

  private static void assertJavas(DoubleSupplier cosines) {
    for (int i = 0; i < DRAWS; i++) {
      assertJavas(cosines.getAsDouble());
    }
  }

  private static void assertJavas(double cosine) {
    assertEquals(StrictMath.acos(cosine), ArcCosine.of(cosine), () -> "of " + cosine);
  }
}
