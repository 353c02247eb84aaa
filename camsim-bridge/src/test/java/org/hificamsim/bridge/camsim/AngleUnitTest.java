package org.hificamsim.bridge.camsim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Tests the conversion of angles for CamSim. */
class AngleUnitTest {
  @Test
  void radiansOfAnyDegreesConvertBackExactly() {
    SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < 100_000; i++) {
      double degrees = i < 3600 ? i / 10.0 - 180 : random.nextDouble(-1000, 1000);
      double radians = Math.toRadians(degrees);
      assertEquals(radians, Math.toRadians(AngleUnit.DEGREES.of(radians)), "of " + degrees);
    }
  }

  @Test
  void anyRadiansConvertBackWithinTwoRoundings() {
    SplittableRandom random = new SplittableRandom(2);
    for (int i = 0; i < 100_000; i++) {
      double radians = random.nextDouble(-20, 20);
      double back = Math.toRadians(AngleUnit.DEGREES.of(radians));
      assertEquals(radians, back, 2 * Math.ulp(radians));
    }
  }

  @Test
  void headingIsNeverValueThatMeansUnchanged() {
    double degrees = AngleUnit.DEGREES.heading(Math.toRadians(-1));
    assertNotEquals(CamSim.UNCHANGED, degrees);
    assertEquals(359, degrees, 1e-9);
    assertEquals(2 * Math.PI - 1, AngleUnit.RADIANS.heading(-1));
    assertEquals(-1.5, AngleUnit.RADIANS.heading(-1.5));
  }
}
