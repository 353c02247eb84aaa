package org.hificamsim.hifi;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.hifi.feature.FeatureAbstraction;
import org.hificamsim.hifi.feature.LinearAbstraction;
import org.hificamsim.hifi.optics.Optics;
import org.junit.jupiter.api.Test;

class HiFiDetectionTest {
  private static final Optics LAB = new Optics(0.0224, 0.085);
  private static final ZoomLevel MIDDLE = new ZoomLevel(5, 2.5, 7.5, Double.NaN, Math.PI);

  @Test
  void appliesTheLineToThePredictedPip() {
    HiFiDetection model = model((q, d, z) -> q * 0.1 + d * 0.01 + z, new DetectorLine(0.5, 0.1));
    // The middle level has half the longest focal length: 0.0425 m.
    assertEquals(0.5 * (0.05 + 0.03 + 0.0425) + 0.1, model.confidence(0.5, 3, 0, MIDDLE), 1e-15);
  }

  @Test
  void doesNotClampConfidence() {
    assertEquals(
        1.25, model((q, d, z) -> 1, new DetectorLine(1, 0.25)).confidence(1, 1, 0, MIDDLE));
    assertEquals(-1, model((q, d, z) -> 0, new DetectorLine(1, -1)).confidence(1, 1, 0, MIDDLE));
  }

  @Test
  void renamingKeepsTheModel() {
    HiFiDetection model = model((q, d, z) -> q, new DetectorLine(1, 0));
    assertEquals("other", model.named("other").name());
    assertEquals(model, model.named("other").named("test"));
  }

  @Test
  void neverDetectsNan() {
    HiFiDetection model = model((q, d, z) -> Double.NaN, new DetectorLine(1, 0));
    assertFalse(model.confidence(1, 1, 0, MIDDLE) >= -1e9);
  }

  @Test
  void literalConfidenceGrowsWithDistanceBeyondOne() {
    LiteralDetection literal =
        new LiteralDetection(
            "hifi-literal", new LinearAbstraction(-10.74, -1.14, 0.11, 1.43), LAB, 0.0441);
    // -10.74*0.0425 - 1.14*0.66 + 0.11*5 + 1.43
    assertEquals(0.77115, literal.confidence(0.66, 5, 0, MIDDLE), 1e-12);
    assertTrue(literal.confidence(0.66, 5, 0, MIDDLE) > literal.confidence(0.66, 1, 0, MIDDLE));
    assertTrue(literal.confidence(0.1, 50, 0, MIDDLE) > 1);
  }

  private static HiFiDetection model(FeatureAbstraction f, DetectorLine g) {
    return new HiFiDetection(
        "test", f, g, LAB, 0.5, Optional.empty(), Optional.empty(), Provenance.UNKNOWN);
  }
}
