package org.hificamsim.hifi.feature;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.Scale;
import org.junit.jupiter.api.Test;

class GeometricAbstractionsTest {
  private static final PinholeAbstraction PINHOLE = new PinholeAbstraction(0.0224, 0.015);
  private static final PowerLawAbstraction POWER = new PowerLawAbstraction(100, 1.5, 1.3, 1.8);

  @Test
  void pinholeProjectsASquare() {
    // A target of 1 m at 5 m through 50 mm is 10 mm on a sensor of 22.4 x 15 mm.
    assertEquals(0.010 * 0.010 / (0.0224 * 0.015), PINHOLE.pip(1, 5, 0.050), 1e-15);
  }

  @Test
  void powerLawMultipliesPowers() {
    assertEquals(
        100 * Math.pow(0.05, 1.5) * Math.pow(0.3, 1.3) / Math.pow(4, 1.8),
        POWER.pip(0.3, 4, 0.05),
        1e-15);
  }

  @Test
  void powerLawWithSquaresIsThePinholeCamera() {
    PowerLawAbstraction squares = new PowerLawAbstraction(1 / (0.0224 * 0.015), 2, 2, 2);
    assertEquals(PINHOLE.pip(0.4, 3, 0.024), squares.pip(0.4, 3, 0.024), 1e-14);
  }

  @Test
  void targetOnTheCameraFillsTheImage() {
    for (double focalLength : new double[] {0, 0.01, 0.085}) {
      assertEquals(1, PINHOLE.pip(0.1, 0, focalLength));
      assertEquals(1, POWER.pip(0.1, 0, focalLength));
      assertEquals(1, new PowerLawAbstraction(1, 1, 1, -1).pip(0.1, 0, focalLength));
    }
  }

  @Property
  void pipFallsWithDistanceAndRisesWithSizeAndZoom(
      @ForAll @Scale(9) @DoubleRange(min = 0.01, max = 3) double size,
      @ForAll @Scale(9) @DoubleRange(min = 0, max = 100) double distance,
      @ForAll @Scale(9) @DoubleRange(min = 0.001, max = 0.3) double focalLength) {
    for (FeatureAbstraction f : new FeatureAbstraction[] {PINHOLE, POWER}) {
      double pip = f.pip(size, distance, focalLength);
      assertTrue(pip >= 0 && pip <= 1, () -> f + " gives " + pip);
      assertTrue(f.pip(size, distance * 1.01 + 0.01, focalLength) <= pip);
      assertTrue(f.pip(size * 1.01, distance, focalLength) >= pip);
      assertTrue(f.pip(size, distance, focalLength * 1.01) >= pip);
    }
  }
}
