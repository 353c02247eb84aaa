package org.hificamsim.network.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** Tests CamSim's own formula for overlaps. */
class CamSimOverlapTest {
  private static final double LENS = 2 * Math.acos(0.5) - Math.sqrt(3) / 2;

  @Test
  void equalsLensIfLaterCameraLiesToTheRight() {
    assertEquals(
        LENS, CamSimOverlap.lensArea(new RangeCircle(0, 0, 1), new RangeCircle(1, 0, 1)), 1e-12);
  }

  @Test
  void q11OverlapIsWrongInOtherPositions() {
    assertEquals(
        2.617993877991494,
        CamSimOverlap.lensArea(new RangeCircle(1, 0, 1), new RangeCircle(0, 0, 1)),
        1e-12,
        "mirrored");
    assertEquals(
        618.6950277230414,
        CamSimOverlap.lensArea(new RangeCircle(0, 0, 16), new RangeCircle(5, 3, 16)),
        1e-9);
    assertEquals(
        984.5550648757603,
        CamSimOverlap.lensArea(new RangeCircle(0, 0, 16), new RangeCircle(-5, 3, 16)),
        1e-9);
  }

  @Test
  void isZeroForDistantOrCoincidentCameras() {
    assertEquals(0, CamSimOverlap.lensArea(new RangeCircle(0, 0, 1), new RangeCircle(0, 0, 1)));
    assertEquals(0, CamSimOverlap.lensArea(new RangeCircle(0, 0, 1), new RangeCircle(3, 0, 1)));
  }
}
