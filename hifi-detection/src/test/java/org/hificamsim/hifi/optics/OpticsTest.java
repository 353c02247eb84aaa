package org.hificamsim.hifi.optics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.Scale;
import org.hificamsim.core.detection.ZoomLevel;
import org.junit.jupiter.api.Test;

class OpticsTest {
  private static final Optics LAB = new Optics(0.0224, 0.085);

  @Test
  void angleOfViewFollowsEquation31() {
    // A lens as long as half the sensor is wide opens by a right angle.
    assertEquals(Math.PI / 2, LAB.angleOfView(0.0112), 1e-15);
    assertEquals(15.02, Math.toDegrees(LAB.angleOfView(0.085)), 0.01);
    assertEquals(96.48, Math.toDegrees(LAB.angleOfView(0.010)), 0.01);
  }

  @Property
  void focalLengthAndRadiusDetermineEachOther(
      @ForAll @Scale(9) @DoubleRange(min = 0.005, max = 0.5) double focalLength,
      @ForAll @Scale(9) @DoubleRange(min = 0.5, max = 50) double mountHeight) {
    double radius = LAB.radius(focalLength, mountHeight);
    assertEquals(focalLength, LAB.focalLength(radius, mountHeight), focalLength * 1e-12);
  }

  @Property
  void focalLengthFollowsFromAKnownHeight(
      @ForAll @Scale(9) @DoubleRange(min = 0.1, max = 20) double radius,
      @ForAll @Scale(9) @DoubleRange(min = 0.5, max = 50) double mountHeight) {
    double focalLength = LAB.focalLength(new ZoomLevel(radius, 0.1, 20, mountHeight, Math.PI));
    assertEquals(radius, LAB.radius(focalLength, mountHeight), radius * 1e-12);
  }

  @Test
  void narrowestLevelOfUnknownHeightHasLongestFocalLength() {
    assertEquals(0.085, LAB.focalLength(level(2.5)));
    assertEquals(0.0425, LAB.focalLength(level(5)), 1e-17);
    assertEquals(0.085 / 3, LAB.focalLength(level(7.5)), 1e-17);
  }

  @Test
  void unknownHeightEqualsHeightOfLongestFocalLength() {
    double height = LAB.mountHeight(2.5, 0.085);
    assertEquals(2 * 2.5 * 0.085 / 0.0224, height, 1e-13);
    for (double radius : new double[] {2.5, 3.75, 5, 6.25, 7.5}) {
      ZoomLevel known = new ZoomLevel(radius, 2.5, 7.5, height, 2 * Math.PI);
      assertEquals(LAB.focalLength(known), LAB.focalLength(level(radius)), 1e-16);
    }
  }

  @Test
  void lensDeterminesFocalLengthByItsAngleOfView() {
    ZoomLevel lens = new ZoomLevel(30, 10, 30, 8, Math.PI / 2, LAB.angleOfView(0.035), 1920);
    assertEquals(0.035, LAB.focalLength(lens), 1e-17);
  }

  @Test
  void radiusZeroHasTheLongestFocalLength() {
    assertEquals(0.085, LAB.focalLength(new ZoomLevel(0, 0, 5, Double.NaN, Math.PI)));
    assertEquals(0.085, LAB.focalLength(new ZoomLevel(0, 0, 5, 8, Math.PI)));
  }

  @Property
  void focalLengthFallsAsTheFieldOfViewWidens(
      @ForAll @Scale(9) @DoubleRange(min = 2.5, max = 100) double radius) {
    assertTrue(LAB.focalLength(level(radius * 1.01)) < LAB.focalLength(level(radius)));
  }

  private static ZoomLevel level(double radius) {
    return new ZoomLevel(radius, 2.5, 7.5, Double.NaN, 2 * Math.PI);
  }
}
