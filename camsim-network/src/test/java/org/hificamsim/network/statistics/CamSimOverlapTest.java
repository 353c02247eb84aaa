package org.hificamsim.network.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** CamSim's own overlap. */
class CamSimOverlapTest {
  private static final double LENS = 2 * Math.acos(0.5) - Math.sqrt(3) / 2;

  @Test
  void isTheLensWhereTheLaterCameraLiesToTheRight() {
    assertEquals(LENS, CamSimOverlap.of(0, 0, 1, 1, 0, 1), 1e-12);
  }

  @Test
  void q11IsFarOffElsewhere() {
    assertEquals(2.617993877991494, CamSimOverlap.of(1, 0, 1, 0, 0, 1), 1e-12, "mirrored");
    assertEquals(618.6950277230414, CamSimOverlap.of(0, 0, 16, 5, 3, 16), 1e-9);
    assertEquals(984.5550648757603, CamSimOverlap.of(0, 0, 16, -5, 3, 16), 1e-9);
  }

  @Test
  void isNothingForCamerasApartOrInOnePlace() {
    assertEquals(0, CamSimOverlap.of(0, 0, 1, 0, 0, 1));
    assertEquals(0, CamSimOverlap.of(0, 0, 1, 3, 0, 1));
  }
}
