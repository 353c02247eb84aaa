package org.hificamsim.core.detection;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.core.detection.camsim.CamSimRangeDetection;
import org.hificamsim.core.detection.camsim.CamSimStandardDetection;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.junit.jupiter.api.Test;

/** Tests detections and their rules, and the defaults of models and zoom levels. */
class DetectionTest {
  private static final ZoomLevel ZOOM = new ZoomLevel(8, 2, 8, Double.NaN, 2 * Math.PI);

  /** A model whose confidence falls from 1 to 0.2 over eight metres. */
  private static final class Falling implements DetectionModel {
    @Override
    public String name() {
      return "falling";
    }

    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return 1 - distance / 10 - (offAxis > 0 ? 0.5 : 0);
    }
  }

  @Test
  void thresholdIgnoresLuck() {
    Detection detection = Detection.of(new Falling());
    assertEquals("falling", detection.name());
    assertEquals("threshold", detection.rule().text());
    assertTrue(detection.certain());
    assertEquals(0.5, detection.threshold());
    assertEquals(1, detection.rule().memory());
    assertEquals(0, detection.rule().phantoms());
    assertEquals(1, detection.chance(0.5));
    assertEquals(0, detection.chance(0.4999));
    assertTrue(detection.detects(0.5, 0.99, 1));
    assertFalse(detection.detects(0.4999, 0, 1));
  }

  @Test
  void thresholdMultipliesValueByTransmittance() {
    Detection detection = Detection.of(new Falling());
    assertTrue(detection.detects(1, 0.99, 0.5));
    assertFalse(detection.detects(1, 0, 0.4999));
    assertFalse(new Detection(new Falling(), 0).detects(1, 0, 0), "nothing gets through");
  }

  @Test
  void chanceIsMultipliedByTransmittance() {
    Detection detection = Detection.by(DetectionRule.parse("probability"), "mine", new Falling());
    assertFalse(detection.certain());
    assertTrue(detection.detects(0.8, 0.3999, 0.5));
    assertFalse(detection.detects(0.8, 0.4, 0.5));
    ChanceTable table = detection.chances(1, ZOOM);
    assertTrue(table.detects(2, 0.3999, 0.5));
    assertFalse(table.detects(2, 0.4001, 0.5));
    assertTrue(table.detects(2, 0.7999, 1));
    assertFalse(table.detects(2, 0.8001, 1));
  }

  @Test
  void phantomsComeAtFalseAlarmRateIfEnabled() {
    assertEquals(0.1, DetectionRule.parse("chance:alpha=0.1,phantoms=on").phantoms());
    assertEquals(0, DetectionRule.parse("chance:alpha=0.1").phantoms());
  }

  @Test
  void tabulatesValuesOfTheModelOnce() {
    Detection detection = Detection.of(new Falling());
    assertEquals(0.7, detection.values(1, ZOOM).value(3), 1e-8);
    assertSame(detection.values(1, ZOOM), detection.values(1, ZOOM));
  }

  @Test
  void modelsHaveThresholdsAndReportProportions() {
    assertEquals(0.5, new Falling().defaultThreshold());
    assertEquals(0.85, new Falling().reported(0.85));
    assertEquals(1, new Falling().reported(1.7));
    assertEquals(0, new Falling().reported(-0.1));
    assertEquals(1, new GeometricDetection().confidence(1, 99, 0, ZOOM));
    assertTrue(new CamSimRangeDetection().defaultThreshold() > 0);
    assertTrue(new CamSimStandardDetection().defaultThreshold() > 0);
    assertEquals(1.7, new CamSimVisibilityDetection().reported(1.7), "near a small camera");
  }

  @Test
  void onAxisModelIgnoresTheBearing() {
    DetectionModel model = new OnAxis(new Falling());
    assertEquals("falling", model.name());
    assertEquals(0.8, model.confidence(1, 2, 1, ZOOM));
  }

  @Test
  void levelOfFullTurnSeesAllRound() {
    assertTrue(ZOOM.allRound());
    assertFalse(new ZoomLevel(8, 2, 8, 3, 6.28).allRound());
    assertFalse(ZOOM.hasLens());
    assertTrue(new ZoomLevel(8, 2, 8, 3, 1, 0.5, 640).hasLens());
  }
}
