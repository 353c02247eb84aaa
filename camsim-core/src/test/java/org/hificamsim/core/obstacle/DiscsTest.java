package org.hificamsim.core.obstacle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class DiscsTest {
  /** Plain double arithmetic puts some of these points on the wrong side. */
  @Test
  void containsBorderPointsAsExactArithmeticDoes() {
    SplittableRandom random = new SplittableRandom(1);
    int wrong = 0;
    for (int trial = 0; trial < 20_000; trial++) {
      double x = random.nextDouble(-9, 9);
      double y = random.nextDouble(-9, 9);
      double radius = random.nextDouble(0.1, 3);
      double angle = random.nextDouble(2 * Math.PI);
      double atX = x + radius * Math.cos(angle);
      double atY = y + radius * Math.sin(angle);
      Point borderPoint = new Point(atX, atY);
      boolean inside =
          Exact.touches(new Obstacle.Pillar(x, y, radius, 0), borderPoint, borderPoint);
      double dx = atX - x;
      double dy = atY - y;
      wrong += dx * dx + dy * dy <= radius * radius == inside ? 0 : 1;
      assertEquals(inside, Discs.contains(x, y, radius, atX, atY));
    }
    assertTrue(wrong > 100, wrong + " that doubles alone get wrong");
  }
}
