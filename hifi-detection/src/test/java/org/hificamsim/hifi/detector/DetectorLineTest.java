package org.hificamsim.hifi.detector;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class DetectorLineTest {
  @Test
  void confidenceIsTheHeightOfTheLine() {
    DetectorLine line = new DetectorLine(0.6, 0.02);
    assertEquals(0.02, line.confidence(0));
    assertEquals(0.32, line.confidence(0.5), 1e-15);
    assertEquals(0.62, line.confidence(1), 1e-15);
  }
}
