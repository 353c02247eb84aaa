package org.hificamsim.presentation.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.spec.Field;
import org.junit.jupiter.api.Test;

class OutlookTest {
  private static final Field FIELD = new Field(0, 30, 0, 20);
  private static final Field AROUND = new Field(-20, 20, -20, 20);
  private static final Obstacle WALL = new Obstacle.Wall(10, 5, 10, 15, 0);
  private static final double REACH = 8;

  @Test
  void hidesAreaBehindWall() {
    List<Double> ring = new Outlook(List.of(WALL), FIELD).from(5, 10, Double.NaN, 15);
    Path2D path = path(ring);
    assertTrue(path.contains(9.9, 10) && path.contains(0.1, 10) && path.contains(12, 2));
    assertFalse(path.contains(10.1, 10) || path.contains(19, 10));
  }

  @Test
  void regionWithoutObstaclesHasFewCorners() {
    List<Double> ring = new Outlook(List.of(WALL), FIELD).from(29, 10, Double.NaN, 8);
    assertTrue(ring.size() < 2 * 40, ring.size() / 2 + " corners");
    Path2D path = path(ring);
    for (int degree = 0; degree < 360; degree++) {
      double x = 29 + 7.99 * Math.cos(Math.toRadians(degree));
      double y = 10 + 7.99 * Math.sin(Math.toRadians(degree));
      assertTrue(path.contains(x, y), degree + " degrees");
    }
  }

  @Property(tries = 500, edgeCases = EdgeCasesMode.NONE)
  void regionContainsExactlyPlacesInSight(@ForAll long seed) {
    Random random = new Random(seed);
    Obstacles obstacles = new Obstacles(Stream.generate(() -> obstacle(random)).limit(8).toList());
    Point camera = point(random);
    if (obstacles.containing(camera.x(), camera.y()).isPresent()) {
      return;
    }
    List<Double> ring =
        new Outlook(obstacles.all(), AROUND).from(camera.x(), camera.y(), Double.NaN, REACH);
    Path2D path = path(ring);
    for (int i = 0; i < 200; i++) {
      Point target = point(random);
      double distance = Math.hypot(target.x() - camera.x(), target.y() - camera.y());
      if (distance < REACH && toBorder(ring, target) > 0.02) {
        assertEquals(
            obstacles.clear(camera.x(), camera.y(), target.x(), target.y()),
            path.contains(target.x(), target.y()),
            () -> "from " + camera + " to " + target + " past " + obstacles.all());
      }
    }
  }

  private static Obstacle obstacle(Random random) {
    Point start = point(random);
    Point end = point(random);
    return switch (random.nextInt(3)) {
      case 0 -> new Obstacle.Wall(start.x(), start.y(), end.x(), end.y(), 0);
      case 1 -> new Obstacle.Pillar(start.x(), start.y(), 0.2 + random.nextDouble(), 0);
      default ->
          new Obstacle.Polygon(
              List.of(
                  start,
                  new Point(start.x() + 2, start.y() + 0.3),
                  new Point(start.x(), start.y() + 3)),
              0);
    };
  }

  private static Point point(Random random) {
    return new Point(random.nextDouble() * 20 - 10, random.nextDouble() * 20 - 10);
  }

  private static double toBorder(List<Double> ring, Point to) {
    return IntStream.range(0, ring.size() / 2)
        .mapToDouble(
            i ->
                Line2D.ptSegDist(
                    ring.get(2 * i),
                    ring.get(2 * i + 1),
                    ring.get((2 * i + 2) % ring.size()),
                    ring.get((2 * i + 3) % ring.size()),
                    to.x(),
                    to.y()))
        .min()
        .orElseThrow();
  }

  /** A wall a tenth of a millimetre below the camera hides half of what is in reach. */
  @Test
  void closeWallHidesHalfOfReach() {
    Path2D path = path(fromOrigin(new Obstacle.Wall(-0.6, -1e-4, 5, -1e-4, 0)));
    assertTrue(path.contains(1, 0.1) && path.contains(-1, 0.1) && path.contains(0, 7));
    assertFalse(path.contains(1, -0.1) || path.contains(0, -7) || path.contains(-4, -0.1));
  }

  /** The camera is on the wall's line up to rounding, which decides the side. */
  @Test
  void cameraOnWallSeesOneSide() {
    Obstacles wall = new Obstacles(List.of(new Obstacle.Wall(-2, 2.3, 2.8, -0.9, 0)));
    assertTrue(wall.clear(1.3, 0.1, 2.2, 0));
    Path2D path = path(new Outlook(wall.all(), AROUND).from(1.3, 0.1, Double.NaN, 1));
    assertTrue(path.contains(1.8, 0.5));
    assertFalse(path.contains(0.9, -0.4));
  }

  /** The two pairs of walls cross at (3, 0) and at (3, 0.5). */
  @Test
  void regionHasCornerWhereWallsCross() {
    assertCorner(3, 0, new Obstacle.Wall(2, -1, 5, 2, 0), new Obstacle.Wall(2, 1, 5, -2, 0));
    assertCorner(3, 0.5, new Obstacle.Wall(2, -2, 4, 3, 0), new Obstacle.Wall(1, 1.5, 5, -0.5, 0));
  }

  /** A pillar at (4, 2) of radius 1, as seen from the origin. */
  @Test
  void borderAtPillarIsRound() {
    List<Double> ring = fromOrigin(new Obstacle.Pillar(4, 2, 1, 0));
    long border =
        IntStream.range(0, ring.size() / 2)
            .filter(i -> Math.hypot(ring.get(2 * i) - 4, ring.get(2 * i + 1) - 2) < 1.01)
            .count();
    assertTrue(border > 15, border + " corners on its border");
  }

  private static void assertCorner(double x, double y, Obstacle... obstacles) {
    List<Double> ring = fromOrigin(obstacles);
    double nearest =
        IntStream.range(0, ring.size() / 2)
            .mapToDouble(i -> Math.hypot(ring.get(2 * i) - x, ring.get(2 * i + 1) - y))
            .min()
            .orElseThrow();
    assertEquals(0, nearest, 0.01, "a corner at (%s, %s)".formatted(x, y));
  }

  private static List<Double> fromOrigin(Obstacle... obstacles) {
    return new Outlook(List.of(obstacles), AROUND).from(0, 0, Double.NaN, REACH);
  }

  @Test
  void transparentObstaclesHideNothing() {
    Obstacle glass = new Obstacle.Wall(10, 5, 10, 15, 0.5);
    assertEquals(List.of(), new Outlook(List.of(glass), FIELD).from(5, 10, Double.NaN, 15));
  }

  @Test
  void cameraInObstacleSeesItsOwnPlaceOnly() {
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
  void cameraLooksOverLowerObstacles() {
    Outlook outlook = new Outlook(List.of(WALL.between(0, 3)), FIELD);
    assertEquals(List.of(), outlook.from(5, 10, 3.1, 15));
    List<Double> hidden = new Outlook(List.of(WALL), FIELD).from(5, 10, Double.NaN, 15);
    assertEquals(hidden, outlook.from(5, 10, 3, 15));
    Outlook canopy = new Outlook(List.of(WALL.between(2.5, 4)), FIELD);
    assertEquals(List.of(), canopy.from(5, 10, 3, 15), "it is walked under");
  }
}
