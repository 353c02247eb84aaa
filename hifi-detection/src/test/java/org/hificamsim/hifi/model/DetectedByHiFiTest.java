package org.hificamsim.hifi.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.Scale;
import org.hificamsim.core.detection.DetectedDistances;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests the detections of the models with the settings of the reproduction: radii of 2.5 to 7.5 m
 * and a size of 0.66 m.
 */
class DetectedByHiFiTest {
  private static final double[] RADII = {2.5, 3.75, 5, 6.25, 7.5};
  private static final double SIZE = 0.66;

  @ParameterizedTest
  @CsvSource({"2.5", "3.75", "5", "6.25", "7.5"})
  void orbLinDetectsUpToTheDistanceOfItsEquations(double radius) {
    DetectedDistances detected = detected("hifi:orb-lin", radius);
    double pip = (0.0441 - 0.026) / 0.571;
    double reach = (-Math.log10(pip) + 18.82 * 0.085 * 2.5 / radius + 2.0 * SIZE - 2.47) / 0.2;
    assertEquals(1, detected.intervals());
    assertEquals(0, detected.from(0));
    assertEquals(Math.min(radius, reach), Math.sqrt(detected.to(0)), 1e-9);
  }

  @Test
  void orbLinDetectsInTheWholeViewOnlyAtNarrowLevels() {
    assertTrue(detected("hifi:orb-lin", 5).contains(25));
    assertFalse(detected("hifi:orb-lin", 6.25).contains(6.25 * 6.25));
    assertFalse(detected("hifi:orb-lin", 7.5).contains(7.5 * 7.5));
  }

  @Test
  void literalModelDetectsEverythingAtTheWidestLevel() {
    DetectedDistances detected = detected("hifi-literal", 7.5);
    assertEquals(1, detected.intervals());
    assertEquals(0, detected.from(0));
    assertTrue(detected.contains(7.5 * 7.5));
  }

  @Test
  void detectorsOfOneAbstractionReachEquallyFar() {
    for (double radius : RADII) {
      double reach = Math.sqrt(detected("hifi:orb-power", radius).to(0));
      assertEquals(reach, Math.sqrt(detected("hifi:sift-power", radius).to(0)), 1e-9);
      assertEquals(reach, Math.sqrt(detected("hifi:surf-power", radius).to(0)), 1e-9);
    }
  }

  @Property
  void confidenceNeverRisesWithDistanceOrFallsWithSize(
      @ForAll @Scale(9) @DoubleRange(min = 0.01, max = 3) double size,
      @ForAll @Scale(9) @DoubleRange(min = 0, max = 50) double distance,
      @ForAll @Scale(9) @DoubleRange(min = 0.5, max = 50) double radius,
      @ForAll @Scale(9) @DoubleRange(min = 0, max = 5) double more) {
    ZoomLevel zoom = level(radius);
    for (String name : new String[] {"lin", "svr-lin", "power", "pinhole", "sr"}) {
      DetectionModel model = Features.registry().create("hifi:orb-" + name);
      double here = model.confidence(size, distance, 0, zoom);
      if (!name.equals("sr")) {
        assertTrue(model.confidence(size, distance + more, 0, zoom) <= here, name);
        assertTrue(model.confidence(size + more, distance, 0, zoom) >= here, name);
      }
      assertTrue(here >= 0 && here <= 1, () -> name + " gives " + here);
    }
  }

  private static DetectedDistances detected(String name, double radius) {
    DetectionModel model = Features.registry().create(name);
    return DetectedDistances.of(model, SIZE, level(radius), model.defaultThreshold());
  }

  private static ZoomLevel level(double radius) {
    return new ZoomLevel(radius, 2.5, 7.5, Double.NaN, 2 * Math.PI);
  }
}
