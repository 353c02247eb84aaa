package org.hificamsim.core.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.hificamsim.core.detection.VerticalView;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.obstacle.Point;
import org.junit.jupiter.api.Test;

class FootprintTest {
  private static ZoomLevel level(double z, double tilt, double across, double upright) {
    return new ZoomLevel(
        100,
        100,
        100,
        Double.NaN,
        Math.toRadians(across),
        Math.toRadians(across),
        1920,
        new VerticalView(z, Math.toRadians(tilt), Math.toRadians(upright)));
  }

  @Test
  void spansGroundBetweenPictureEdges() {
    Footprint ground = Footprint.of(level(3, 30, 60, 40), 0, 0);
    assertEquals(3 / Math.tan(Math.toRadians(50)), ground.near(), 1e-12);
    assertEquals(3 / Math.tan(Math.toRadians(10)), ground.far(), 1e-12);
    List<Point> corners = ground.corners(100);
    assertEquals(ground.far(), corners.get(2).y(), 1e-12);
    // At the far edge the picture is h / sin(10 degrees) times cos(20 degrees) deep.
    double depth = 3 / Math.sin(Math.toRadians(10)) * Math.cos(Math.toRadians(20));
    assertEquals(depth * Math.tan(Math.toRadians(30)), corners.get(2).x(), 1e-9);
  }

  @Test
  void isOpenTowardsHorizonAndBelowTheCamera() {
    assertEquals(Double.POSITIVE_INFINITY, Footprint.of(level(3, 10, 60, 40), 0, 0).far());
    Footprint down = Footprint.of(level(3, 90, 60, 40), 0, 0);
    assertTrue(down.contains(0, 0) && down.contains(-1, 0) && !down.contains(-1.2, 0));
  }

  @Test
  void isEmptyIfCameraLooksOverTarget() {
    assertTrue(Footprint.of(level(3, -30, 60, 40), 0, 1.7).isEmpty(100));
    assertTrue(Footprint.of(level(3, 0, 60, 2), 0, 1.7).isEmpty(50));
    assertFalse(Footprint.of(level(3, 0, 60, 20), 0, 1.7).isEmpty(50));
  }

  /** Projects with a rotation matrix and a division. */
  @Test
  void agreesWithFullProjection() {
    Random random = new Random(1);
    int inside = 0;
    for (int i = 0; i < 100_000; i++) {
      double z = 10 * random.nextDouble();
      double tilt = 180 * random.nextDouble() - 90;
      double across = 10 + 100 * random.nextDouble();
      double upright = 10 + 80 * random.nextDouble();
      double ahead = 40 * random.nextDouble() - 10;
      double right = 40 * random.nextDouble() - 20;
      double low = random.nextBoolean() ? 0 : 1.7;
      boolean seen = true;
      for (double height : new double[] {low, 1.7}) {
        double t = Math.toRadians(tilt);
        double[] axis = {Math.cos(t), -Math.sin(t)};
        double depth = ahead * axis[0] + (height - z) * axis[1];
        double up = ahead * -axis[1] + (height - z) * axis[0];
        seen &=
            depth > 0
                && Math.abs(right / depth) <= Math.tan(Math.toRadians(across / 2))
                && Math.abs(up / depth) <= Math.tan(Math.toRadians(upright / 2));
      }
      Footprint footprint = Footprint.of(level(z, tilt, across, upright), low, 1.7);
      assertEquals(seen, footprint.contains(ahead, right));
      inside += seen ? 1 : 0;
    }
    assertTrue(inside > 5_000, () -> "too few to mean anything");
  }
}
