package org.hificamsim.hifi.detector;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import org.junit.jupiter.api.Test;

class DetectorLineTest {
  @Test
  void confidenceIsTheValueOfTheLine() {
    DetectorLine line = new DetectorLine(0.6, 0.02);
    assertEquals(0.02, line.confidence(0));
    assertEquals(0.32, line.confidence(0.5), 1e-15);
    assertEquals(0.62, line.confidence(1), 1e-15);
  }

  @Test
  void pipInvertsConfidence() {
    DetectorLine line = new DetectorLine(0.571, 0.026);
    assertEquals(0.0317, line.pip(0.0441), 5e-5);
    assertEquals(0.3, line.pip(line.confidence(0.3)), 1e-15);
  }

  @Test
  void horizontalLineHasNoPip() {
    assertFalse(Double.isFinite(new DetectorLine(0, 0.1).pip(0.2)));
  }
}
