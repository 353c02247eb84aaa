package org.hificamsim.core.detection;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DetectedDistancesTest {
  /** Cosine models detect nothing, everything, or any number of rings. */
  @Property(tries = 500, edgeCases = EdgeCasesMode.NONE)
  void agreesWithTheModel(
      @ForAll @DoubleRange(min = 0.01, max = 50) double radius,
      @ForAll @IntRange(max = 9) int waves,
      @ForAll @DoubleRange(min = 0, max = 6.3) double phase,
      @ForAll @DoubleRange(min = -1.2, max = 1.2) double threshold,
      @ForAll long seed) {
    DetectionModel model = model(d -> Math.cos(phase + waves * Math.PI * d / radius));
    DetectedDistances set = distances(model, radius, threshold);
    SplittableRandom random = new SplittableRandom(seed);
    for (int i = 0; i < 200; i++) {
      double distance = random.nextDouble(1.1 * radius);
      double value = model.confidence(1, distance, 0, zoom(radius));
      if (Math.abs(value - threshold) > 1e-6) {
        assertEquals(
            distance <= radius && value >= threshold,
            set.contains(distance * distance),
            () -> distance + " of " + set);
      }
    }
    assertEndsAreExact(set, model, radius, threshold);
  }

  private static void assertEndsAreExact(
      DetectedDistances set, DetectionModel model, double radius, double threshold) {
    double last = -1;
    for (int i = 0; i < set.intervals(); i++) {
      assertTrue(last < set.from(i) && set.from(i) <= set.to(i), set::toString);
      last = set.to(i);
      assertTrue(detects(model, set.from(i), radius, threshold), "start of " + set);
      assertTrue(detects(model, set.to(i), radius, threshold), "end of " + set);
      assertTrue(set.contains(set.from(i)) && set.contains(set.to(i)));
      assertFalse(detects(model, Math.nextUp(set.to(i)), radius, threshold), "beyond " + set);
      if (set.from(i) > 0) {
        assertFalse(detects(model, Math.nextDown(set.from(i)), radius, threshold), "before " + set);
      }
    }
  }

  private static boolean detects(
      DetectionModel model, double squared, double radius, double threshold) {
    double distance = Math.sqrt(squared);
    return distance <= radius && model.confidence(1, distance, 0, zoom(radius)) >= threshold;
  }

  @Test
  void fallingModelGivesOneIntervalFromZero() {
    DetectedDistances set = distances(model(d -> 1 - d / 10), 8, 0.5);
    assertEquals(1, set.intervals());
    assertEquals(0, set.from(0));
    assertEquals(25, set.to(0), 1e-12);
  }

  @Test
  void risingModelGivesRingUpToTheRadius() {
    DetectedDistances set = distances(model(d -> d / 10), 8, 0.5);
    assertEquals(1, set.intervals());
    assertEquals(25, set.from(0), 1e-12);
    assertEquals(8, Math.sqrt(set.to(0)));
    assertTrue(set.contains(64));
    assertFalse(set.contains(24.9));
  }

  @Test
  void fourCrossingsOfThresholdGiveTwoRings() {
    DetectedDistances set = distances(model(d -> -Math.cos(d * Math.PI / 2)), 8, 0);
    assertEquals(2, set.intervals());
    assertFalse(set.contains(0));
    assertTrue(set.contains(4));
    assertFalse(set.contains(16));
    assertTrue(set.contains(36));
    assertFalse(set.contains(64));
  }

  @Test
  void isEmptyIfNothingIsDetected() {
    DetectedDistances set = distances(model(d -> 0), 8, 0.5);
    assertEquals(0, set.intervals());
    assertFalse(set.contains(0));
    assertEquals(DetectedDistances.NONE, set);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 1e-200, 1e-9, 1, 7.3, 1e9, 1e17, 1e100, 1e200, 1e308})
  void endsAtRadiusIfEverythingIsDetected(double radius) {
    DetectedDistances set = distances(model(d -> 1), radius, 0.5);
    assertEquals(1, set.intervals());
    assertEquals(0, set.from(0));
    assertTrue(Math.sqrt(set.to(0)) <= radius);
    assertTrue(Math.sqrt(Math.nextUp(set.to(0))) > radius);
    assertTrue(set.contains(0));
  }

  @Test
  void radiusOfZeroContainsOnlyTheCamera() {
    DetectedDistances set = distances(model(d -> 1), 0, 0.5);
    assertTrue(set.contains(0));
    assertFalse(set.contains(Double.MIN_VALUE));
    assertEquals(DetectedDistances.NONE, distances(model(d -> 0), 0, 0.5));
  }

  @Test
  void neverDetectsNaN() {
    assertEquals(DetectedDistances.NONE, distances(model(d -> Double.NaN), 8, 0));
    assertEquals(
        DetectedDistances.NONE, distances(model(d -> Double.NaN), 8, Double.NEGATIVE_INFINITY));
    DetectedDistances partly = distances(model(d -> d < 4 ? 1 : Double.NaN), 8, 0.5);
    assertTrue(partly.contains(Math.nextDown(4.0) * Math.nextDown(4.0)));
    assertFalse(partly.contains(16));
    assertFalse(partly.contains(Double.NaN));
  }

  @Test
  void detectsValueAtTheThreshold() {
    assertEquals(1, distances(model(d -> 0.5), 8, 0.5).intervals());
    assertEquals(0, distances(model(d -> Math.nextDown(0.5)), 8, 0.5).intervals());
  }

  @Test
  void includesSetsOfContainedDistances() {
    DetectedDistances everything = distances(model(d -> 1), 8, 0.5);
    DetectedDistances near = distances(model(d -> 1 - d / 10), 8, 0.5);
    DetectedDistances far = distances(model(d -> d / 10), 8, 0.2);
    DetectedDistances rings = distances(model(d -> Math.cos(d * Math.PI / 2)), 8, 0);
    for (DetectedDistances set : new DetectedDistances[] {everything, near, far, rings}) {
      assertTrue(set.includes(set));
      assertTrue(everything.includes(set));
      assertTrue(set.includes(DetectedDistances.NONE));
      assertFalse(DetectedDistances.NONE.includes(set));
    }
    assertFalse(near.includes(far));
    assertFalse(far.includes(near));
    assertFalse(rings.includes(near), "a gap counts");
    assertFalse(near.includes(rings));
    assertTrue(DetectedDistances.NONE.includes(DetectedDistances.NONE));
  }

  @Property(tries = 200)
  void lowerThresholdIncludesHigherOne(
      @ForAll @DoubleRange(min = -1, max = 1) double first,
      @ForAll @DoubleRange(min = -1, max = 1) double other) {
    DetectionModel model = model(d -> Math.cos(3 * d));
    assertTrue(
        distances(model, 5, Math.min(first, other))
            .includes(distances(model, 5, Math.max(first, other))));
  }

  @Test
  void equalDistancesMakeEqualSets() {
    DetectedDistances set = distances(model(d -> 1), 8, 0.5);
    assertEquals(set, distances(model(d -> 2), 8, 0.5));
    assertEquals(set.hashCode(), distances(model(d -> 2), 8, 0.5).hashCode());
    assertNotEquals(set, distances(model(d -> 1), 7, 0.5));
  }

  @Test
  void rejectsModelThatDependsOnBearing() {
    CamSimVisibilityDetection model = new CamSimVisibilityDetection();
    IllegalArgumentException error =
        assertThrows(IllegalArgumentException.class, () -> distances(model, 8, 0.5));
    assertTrue(error.getMessage().contains("camsim-visibility"), error.getMessage());
  }

  private static DetectedDistances distances(
      DetectionModel model, double radius, double threshold) {
    return new Detection(model, threshold).distances(1, zoom(radius));
  }

  private static ZoomLevel zoom(double radius) {
    return new ZoomLevel(radius, radius, radius, Double.NaN, 2 * Math.PI);
  }

  private static DetectionModel model(DoubleUnaryOperator confidenceAtDistance) {
    return new DetectionModel() {
      @Override
      public String name() {
        return "test";
      }

      @Override
      public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
        return confidenceAtDistance.applyAsDouble(distance);
      }
    };
  }
}
