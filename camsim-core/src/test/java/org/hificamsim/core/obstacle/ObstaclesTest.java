package org.hificamsim.core.obstacle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.prep.PreparedGeometryFactory;

class ObstaclesTest {
  private static final GeometryFactory JTS = new GeometryFactory();
  private static final Obstacle WALL = new Obstacle.Wall(0, 0, 0, 4, 0.5);
  private static final Obstacle SOLID = new Obstacle.Wall(2, 0, 2, 4, 0);
  private static final Obstacle PILLAR = new Obstacle.Pillar(-3, 2, 1, 0.25);

  @Test
  void transmittancesMultiplyAlongTheRay() {
    Obstacles obstacles = new Obstacles(List.of(WALL, SOLID, PILLAR));
    assertEquals(0.5, obstacles.transmittance(-1, 2, 1, 2));
    assertEquals(0.125, obstacles.transmittance(-9, 2, 1, 2));
    assertEquals(0, obstacles.transmittance(-9, 2, 2, 2));
    assertEquals(1, obstacles.transmittance(-9, 9, 9, 9));
  }

  @Test
  void countsObstacleOncePerRay() {
    Obstacle comb =
        new Obstacle.Polygon(
            List.of(
                new Point(0, 0),
                new Point(5, 0),
                new Point(5, 4),
                new Point(4, 1),
                new Point(1, 1),
                new Point(0, 4)),
            0.5);
    assertEquals(0.5, new Obstacles(List.of(comb)).transmittance(-9, 2, 9, 2));
  }

  @Test
  void onlySolidObstaclesBlock() {
    Obstacles obstacles = new Obstacles(List.of(WALL, SOLID));
    assertTrue(obstacles.clear(-1, 2, 1, 2));
    assertFalse(obstacles.clear(-1, 2, 3, 2));
    assertFalse(obstacles.clear(1, 5, 2, 4), "touches an end");
  }

  @Test
  void onlySolidObstaclesContainPoints() {
    Obstacles obstacles = new Obstacles(List.of(PILLAR, SOLID));
    assertEquals(Optional.empty(), obstacles.containing(-3, 2));
    assertEquals(Optional.of(SOLID), obstacles.containing(2, 4));
  }

  @Test
  void findsObstaclesNearRectangle() {
    Obstacles obstacles = new Obstacles(List.of(WALL, SOLID, PILLAR));
    assertEquals(new Obstacles(List.of(WALL, SOLID)), obstacles.near(2, 4, 0, 5));
    assertEquals(new Obstacles(List.of(PILLAR)), obstacles.near(-9, 0, -1, 3));
    assertEquals(Obstacles.NONE, obstacles.near(3, 0, 9, 9));
  }

  @Test
  void equalIfTheirObstaclesAreEqual() {
    Obstacles obstacles = new Obstacles(List.of(WALL, PILLAR));
    Obstacles same = new Obstacles(List.of(new Obstacle.Wall(0, 0, 0, 4, 0.5), PILLAR));
    assertEquals(obstacles, same);
    assertEquals(obstacles.hashCode(), same.hashCode());
    assertNotEquals(obstacles, new Obstacles(List.of(PILLAR, WALL)));
    assertEquals(List.of(WALL, PILLAR).toString(), obstacles.toString());
  }

  @Test
  void emptyObstaclesBlockNothing() {
    assertTrue(Obstacles.NONE.isEmpty());
    assertEquals(1, Obstacles.NONE.transmittance(0, 0, 1, 1));
    assertTrue(Obstacles.NONE.clear(0, 0, 0, 0));
  }

  @Property(tries = 1000, edgeCases = EdgeCasesMode.NONE)
  void touchesAgreeWithJts(@ForAll long seed) {
    RandomPlace place = RandomPlace.forJts(seed);
    assertTouched(place, place.obstacles(6, false), ObstaclesTest::byJts);
  }

  @Property(tries = 600, edgeCases = EdgeCasesMode.NONE)
  void touchesAgreeWithExactArithmetic(@ForAll long seed) {
    RandomPlace place = seed % 2 == 0 ? RandomPlace.ofAnySize(seed) : new RandomPlace(seed);
    List<Obstacle> exact =
        place.obstacles(10, false).all().stream()
            .filter(obstacle -> !(obstacle instanceof Obstacle.Polygon))
            .toList();
    assertTouched(place, new Obstacles(exact), Exact::touches);
  }

  private interface Touch {
    boolean test(Obstacle obstacle, Point from, Point to);
  }

  private static void assertTouched(RandomPlace place, Obstacles obstacles, Touch expected) {
    for (int i = 0; i < 50; i++) {
      Point from = place.target(obstacles, place.point());
      Point to = i == 0 ? from : place.target(obstacles, from);
      for (Obstacle obstacle : obstacles.all()) {
        assertEquals(
            expected.test(obstacle, from, to),
            obstacle.touches(from.x(), from.y(), to.x(), to.y()),
            () -> from + " to " + to + " and " + obstacle);
      }
    }
  }

  /**
   * Whether a segment touches an obstacle according to JTS, or to exact arithmetic for pillars,
   * because JTS has no discs.
   */
  private static boolean byJts(Obstacle obstacle, Point from, Point to) {
    return obstacle instanceof Obstacle.Pillar
        ? Exact.touches(obstacle, from, to)
        : PreparedGeometryFactory.prepare(geometry(obstacle)).intersects(segment(from, to));
  }

  private static Geometry segment(Point from, Point to) {
    return from.equals(to) ? JTS.createPoint(coordinateOf(from)) : line(from, to);
  }

  private static Geometry line(Point from, Point to) {
    return JTS.createLineString(new Coordinate[] {coordinateOf(from), coordinateOf(to)});
  }

  private static Geometry geometry(Obstacle obstacle) {
    if (obstacle instanceof Obstacle.Polygon polygon) {
      Stream<Point> ring =
          Stream.concat(polygon.points().stream(), Stream.of(polygon.points().get(0)));
      return JTS.createPolygon(ring.map(ObstaclesTest::coordinateOf).toArray(Coordinate[]::new));
    }
    Obstacle.Wall wall = (Obstacle.Wall) obstacle;
    return line(new Point(wall.x1(), wall.y1()), new Point(wall.x2(), wall.y2()));
  }

  private static Coordinate coordinateOf(Point point) {
    return new Coordinate(point.x(), point.y());
  }
}
