package org.hificamsim.presentation.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Path2D;
import java.util.List;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.scenario.Field;
import org.junit.jupiter.api.Test;

class OutlookTest {
  private static final Field FIELD = new Field(0, 30, 0, 20);
  private static final Obstacle WALL = new Obstacle.Wall(10, 5, 10, 15, 0);

  @Test
  void whatIsBehindAWallIsOutside() {
    List<Double> ring = new Outlook(List.of(WALL), FIELD).from(5, 10, Double.NaN, 15);
    Path2D path = path(ring);
    assertTrue(path.contains(9.9, 10) && path.contains(0.1, 10) && path.contains(12, 2));
    assertFalse(path.contains(10.1, 10) || path.contains(19, 10));
  }

  @Test
  void whereNothingIsInTheWayFewCornersReachBeyondTheReach() {
    List<Double> ring = new Outlook(List.of(WALL), FIELD).from(29, 10, Double.NaN, 8);
    assertTrue(ring.size() < 2 * 40, ring.size() / 2 + " corners");
    Path2D path = path(ring);
    for (int degree = 0; degree < 360; degree++) {
      double x = 29 + 7.99 * Math.cos(Math.toRadians(degree));
      double y = 10 + 7.99 * Math.sin(Math.toRadians(degree));
      assertTrue(path.contains(x, y), degree + " degrees");
    }
  }

  @Test
  void whatDimsAloneCutsNothingOff() {
    Obstacle glass = new Obstacle.Wall(10, 5, 10, 15, 0.5);
    assertEquals(List.of(), new Outlook(List.of(glass), FIELD).from(5, 10, Double.NaN, 15));
  }

  @Test
  void aCameraInAWallSeesNothing() {
    assertEquals(
        List.of(10.0, 10.0), new Outlook(List.of(WALL), FIELD).from(10, 10, Double.NaN, 15));
  }

  private static Path2D path(List<Double> ring) {
    Path2D path = new Path2D.Double();
    path.moveTo(ring.get(0), ring.get(1));
    for (int i = 2; i < ring.size(); i += 2) {
      path.lineTo(ring.get(i), ring.get(i + 1));
    }
    path.closePath();
    return path;
  }

  @Test
  void aCameraLooksOverWhatIsLowerThanItself() {
    Outlook outlook = new Outlook(List.of(WALL.between(0, 3)), FIELD);
    assertEquals(List.of(), outlook.from(5, 10, 3.1, 15));
    List<Double> hidden = new Outlook(List.of(WALL), FIELD).from(5, 10, Double.NaN, 15);
    assertEquals(hidden, outlook.from(5, 10, 3, 15));
    Outlook canopy = new Outlook(List.of(WALL.between(2.5, 4)), FIELD);
    assertEquals(List.of(), canopy.from(5, 10, 3, 15), "it is walked under");
  }
}
