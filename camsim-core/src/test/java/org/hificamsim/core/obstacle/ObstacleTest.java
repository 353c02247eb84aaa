package org.hificamsim.core.obstacle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;

class ObstacleTest {
  @Test
  void segmentTouchesWallAtEndsAndAlongIt() {
    Obstacle wall = new Obstacle.Wall(0, 0, 4, 2, 0);
    assertTrue(wall.touches(0, 2, 4, 0));
    assertTrue(wall.touches(4, 2, 9, 9), "begins at the end");
    assertTrue(wall.touches(2, 1, 2, 5), "begins on it");
    assertTrue(wall.touches(-2, -1, 8, 4), "runs along it");
    assertTrue(wall.touches(3, 1.5, 1, 0.5), "lies within it");
    assertFalse(wall.touches(6, 3, 8, 4), "in line with it, and beyond");
    assertFalse(wall.touches(0, 1, 4, 3), "parallel");
    assertFalse(wall.touches(0, 2, 2, Math.nextUp(1.0)), "ends just before it");
  }

  @Test
  void segmentTouchesPolygonOnBorderAndInside() {
    Obstacle house = polygon(0, 0, 4, 0, 4, 4, 2, 2, 0, 4);
    assertTrue(house.touches(-1, 4, 1, 4), "by a corner");
    assertTrue(house.touches(1, 1, 1.5, 1), "inside as a whole");
    assertTrue(house.touches(-5, 0, 9, 0), "along an edge");
    assertTrue(house.touches(2, 2, 2, 9), "from the notch");
    assertFalse(house.touches(1.5, 4, 2.5, 4), "within the notch");
    assertTrue(house.contains(1, 0.5));
    assertTrue(house.contains(4, 3), "on the border");
    assertTrue(house.contains(0, 4), "at a corner");
    assertFalse(house.contains(2, 2.5), "in the notch");
    assertFalse(house.contains(-1, 2), "in line with corners, outside");
  }

  @Test
  void segmentTouchesPillarOnBorderAndInside() {
    Obstacle pillar = new Obstacle.Pillar(3, 4, 5, 0);
    assertTrue(pillar.contains(0, 0), "on the border");
    assertFalse(pillar.contains(Math.nextDown(0.0) - 1e-300, 0), "just outside");
    assertTrue(pillar.touches(-9, -1, 9, -1), "a tangent");
    assertFalse(pillar.touches(-9, Math.nextDown(-1.0), 9, Math.nextDown(-1.0)));
    assertTrue(pillar.touches(-9, 4, -2, 4), "ends on it");
    assertFalse(pillar.touches(-9, 4, Math.nextDown(-2.0), 4), "ends before it");
    assertTrue(pillar.touches(3, 4, 3, 5), "within it");
  }

  @Test
  void rejectsInvalidShapesWithExpectation() {
    assertRejected(
        "both ends are (1.0, 2.0), expected two points", () -> new Obstacle.Wall(1, 2, 1, 2, 0));
    assertRejected(
        "coordinate is NaN, expected a number between -1e100 and 1e100",
        () -> new Obstacle.Wall(1, Double.NaN, 1, 2, 0));
    assertRejected(
        "transmittance is 1.5, expected a number between 0 and 1",
        () -> new Obstacle.Wall(1, 3, 1, 2, 1.5));
    assertRejected(
        "radius is 0.0, expected a number above 0, and 1e100 at most",
        () -> new Obstacle.Pillar(1, 3, 0, 0));
    assertRejected("polygon has 2 points, expected 3 or more", () -> polygon(0, 0, 1, 1));
    assertRejected(
        "all points of the polygon are on one line, expected an area",
        () -> polygon(0, 0, 1, 1, 3, 3, 2, 2));
    String edges = " of the polygon touch, expected edges that share corners with their neighbours";
    assertRejected("edges 1 and 3" + edges + " alone", () -> polygon(0, 0, 4, 4, 4, 0, 0, 4));
    assertRejected("edges 1 and 2" + edges + " alone", () -> polygon(0, 0, 4, 0, 2, 0, 2, 2));
    assertRejected("edges 1 and 4" + edges + " alone", () -> polygon(0, 0, 4, 0, 4, 4, 6, 0));
    assertRejected("edges 1 and 2" + edges + " alone", () -> polygon(0, 0, 4, 0, 4, 0, 2, 2));
    assertRejected(
        "the last point of the polygon repeats the first, expected each point once",
        () -> polygon(0, 0, 4, 0, 4, 4, 0, 0));
  }

  @Test
  void rejectsInvalidCorners() {
    String expected = ", expected a number between -1e100 and 1e100";
    assertRejected("coordinate is NaN" + expected, () -> polygon(0, 0, Double.NaN, 0, 4, 4));
    assertRejected("coordinate is -2.0E100" + expected, () -> polygon(0, 0, 4, -2e100, 4, 4));
  }

  @Test
  void acceptsLargestCoordinates() {
    assertTrue(new Obstacle.Wall(-1e100, 0, 1e100, 0, 1).touches(0, -1, 0, 1));
    assertTrue(new Obstacle.Pillar(0, 0, 1e100, 0).contains(1e99, 0));
    assertTrue(polygon(0, 0, 1, 0, 0, 1).contains(0.1, 0.1), "three corners");
  }

  private static void assertRejected(String message, Executable construction) {
    assertEquals(message, assertThrows(IllegalArgumentException.class, construction).getMessage());
  }

  static Obstacle polygon(double... coordinates) {
    List<Point> points = new ArrayList<>();
    for (int i = 0; i < coordinates.length; i += 2) {
      points.add(new Point(coordinates[i], coordinates[i + 1]));
    }
    return new Obstacle.Polygon(points, 0);
  }
}
