package org.hificamsim.core.obstacle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.locationtech.jts.algorithm.Area;
import org.locationtech.jts.algorithm.locate.SimplePointInAreaLocator;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.LinearRing;
import org.locationtech.jts.geom.Location;
import org.locationtech.jts.math.Vector2D;
import org.locationtech.jts.operation.union.UnaryUnionOp;

class OutlineTest {
  private static final GeometryFactory JTS = new GeometryFactory();
  private static final double REACH = 8;

  @Property(tries = 1000, edgeCases = EdgeCasesMode.NONE)
  void whatIsInsideIsSeenAndWhatIsOutsideIsNot(@ForAll long seed) {
    RandomPlace place = new RandomPlace(seed);
    Obstacles obstacles = place.obstacles(10, false);
    Point at = place.point();
    if (obstacles.containing(at.x(), at.y()).isPresent()) {
      return;
    }
    LinearRing ring = ring(VisibleRegion.of(obstacles, at.x(), at.y(), REACH).polygon(REACH));
    for (int i = 0; i < 100; i++) {
      Point target = place.target(obstacles, at);
      Coordinate asked = new Coordinate(target.x(), target.y());
      boolean seen = seen(obstacles, at, target, 0);
      boolean inThinShadow =
          seen(obstacles, at, target, 1e-6) != seen && seen(obstacles, at, target, -1e-6) != seen;
      if (!inThinShadow && ring.distance(JTS.createPoint(asked)) > 0.02) {
        assertEquals(
            seen,
            SimplePointInAreaLocator.locate(asked, JTS.createPolygon(ring)) == Location.INTERIOR,
            () -> "from " + at + " to " + target + " past " + obstacles.all());
      }
    }
  }

  /** Whether a target is seen, turned by an angle about the camera. */
  private static boolean seen(Obstacles obstacles, Point at, Point target, double angle) {
    double dx = target.x() - at.x();
    double dy = target.y() - at.y();
    return Math.hypot(dx, dy) <= REACH
        && obstacles.clear(at.x(), at.y(), at.x() + dx - angle * dy, at.y() + dy + angle * dx);
  }

  @Property(tries = 500, edgeCases = EdgeCasesMode.NONE)
  void itsAreaIsThatOfADiscWithoutTheShadowsThatJtsCuts(@ForAll long seed) {
    RandomPlace place = new RandomPlace(seed);
    Obstacles obstacles = place.obstacles(8, true);
    Point at = new Point(0.123, 0.456);
    if (obstacles.containing(at.x(), at.y()).isPresent()) {
      return;
    }
    List<Geometry> shadows = new ArrayList<>();
    Pieces pieces = obstacles.pieces();
    for (int i = 0; i < pieces.count(); i++) {
      if (pieces.radius[i] > 0) {
        return;
      }
      shadows.add(shadow(at, pieces, i));
    }
    Geometry disc = JTS.createPoint(new Coordinate(at.x(), at.y())).buffer(REACH, 128);
    Geometry seen = shadows.isEmpty() ? disc : disc.difference(UnaryUnionOp.union(shadows));
    List<Point> polygon = VisibleRegion.of(obstacles, at.x(), at.y()).polygon(REACH);
    assertEquals(
        seen.getArea(),
        Area.ofRing(ring(polygon).getCoordinates()),
        0.001 * REACH * REACH,
        () -> "past " + obstacles.all());
  }

  /**
   * An edge and what is behind it, far beyond the reach: also in the middle, which may be half a
   * turn away from both ends where the standpoint is beside a wall.
   */
  private static Geometry shadow(Point at, Pieces pieces, int edge) {
    Vector2D one = direction(at, pieces.x1[edge], pieces.y1[edge]);
    Vector2D other = direction(at, pieces.x2[edge], pieces.y2[edge]);
    Coordinate end = new Coordinate(pieces.x1[edge], pieces.y1[edge]);
    return JTS.createPolygon(
        new Coordinate[] {
          end,
          new Coordinate(pieces.x2[edge], pieces.y2[edge]),
          far(at, other),
          far(at, one.add(other).normalize()),
          far(at, one),
          end
        });
  }

  private static Vector2D direction(Point at, double x, double y) {
    return Vector2D.create(x - at.x(), y - at.y()).normalize();
  }

  private static Coordinate far(Point at, Vector2D direction) {
    return direction.multiply(1e4).translate(new Coordinate(at.x(), at.y()));
  }

  /** A wall a tenth of a millimetre below the standpoint hides half of the disc. */
  @Test
  void aWallCloseToTheStandpointHidesWhatIsBehindIt() {
    Obstacle wall = new Obstacle.Wall(-0.6, -1e-4, 5, -1e-4, 0);
    List<Point> polygon = VisibleRegion.of(new Obstacles(List.of(wall)), 0, 0).polygon(REACH);
    double half = Math.PI * REACH * REACH / 2;
    assertEquals(half, Area.ofRing(ring(polygon).getCoordinates()), 0.001 * REACH * REACH);
  }

  private static LinearRing ring(List<Point> points) {
    List<Coordinate> corners = new ArrayList<>();
    points.forEach(point -> corners.add(new Coordinate(point.x(), point.y())));
    corners.add(corners.get(0));
    return JTS.createLinearRing(corners.toArray(Coordinate[]::new));
  }

  @Test
  void aStandpointOnASolidBorderSeesNoArea() {
    Obstacles wall = new Obstacles(List.of(new Obstacle.Wall(0, 0, 4, 0, 0)));
    assertEquals(List.of(), VisibleRegion.of(wall, 2, 0).polygon(5));
  }

  /** Its coordinates are of a wall's line but for rounding, which decides the side. */
  @Test
  void aStandpointAsGoodAsOnAWallSeesTheSideThatItIsOn() {
    Obstacles wall = new Obstacles(List.of(new Obstacle.Wall(-2, 2.3, 2.8, -0.9, 0)));
    assertTrue(wall.clear(1.3, 0.1, 2.2, 0));
    List<Point> polygon = VisibleRegion.of(wall, 1.3, 0.1).polygon(1);
    assertEquals(Math.PI / 2, Area.ofRing(ring(polygon).getCoordinates()), 0.001);
    assertTrue(polygon.stream().anyMatch(p -> p.x() > 2.2 && p.y() > 0));
  }

  @Test
  void aWallCutsTheRegionStraight() {
    Obstacles wall = new Obstacles(List.of(new Obstacle.Wall(2, -9, 2, 9, 0)));
    List<Point> polygon = VisibleRegion.of(wall, 0, 0).polygon(4);
    double farthest = polygon.stream().mapToDouble(Point::x).max().orElseThrow();
    assertEquals(2, farthest, 1e-9);
    assertTrue(polygon.stream().filter(p -> p.x() > 2 - 1e-9).count() <= 3, "few corners");
  }

  /** Of walls that cross 3 m ahead, at (3, 0). */
  @Test
  void aCornerIsWhereWallsCross() {
    assertCorner(3, 0, new Obstacle.Wall(2, -1, 5, 2, 0), new Obstacle.Wall(2, 1, 5, -2, 0));
    assertCorner(3, 0.5, new Obstacle.Wall(2, -2, 4, 3, 0), new Obstacle.Wall(1, 1.5, 5, -0.5, 0));
  }

  @Test
  void aCornerIsWhereAWallLeavesTheReach() {
    Obstacle wall = new Obstacle.Wall(3, -99, 3, 20, 0);
    assertCorner(3, Math.sqrt(64 - 9), wall);
    assertCorner(3, -Math.sqrt(64 - 9), wall);
    assertCorner(-Math.sqrt(64 - 4), 2, new Obstacle.Wall(-50, 2, 1, 2, 0));
  }

  /** A wall along y = 2 enters a pillar about (4, 3) at 4 - 1. */
  @Test
  void aCornerIsWhereAWallEntersAPillar() {
    Obstacle pillar = new Obstacle.Pillar(4, 3, Math.sqrt(2), 0);
    Obstacle wall = new Obstacle.Wall(-1, 2, 6, 2, 0);
    assertCorner(3, 2, pillar, wall);
    assertCorner(3, 2, wall, pillar);
  }

  @Test
  void aPillarIsRound() {
    Obstacles pillar = new Obstacles(List.of(new Obstacle.Pillar(4, 2, 1, 0)));
    List<Point> polygon = VisibleRegion.of(pillar, 0, 0).polygon(REACH);
    List<Point> border =
        polygon.stream().filter(p -> Math.hypot(p.x() - 4, p.y() - 2) < 1 + 1e-6).toList();
    assertTrue(border.size() > 15, border.size() + " corners on its border");
    double tangent = Math.sqrt(20 - 1);
    double toTheRight = Math.atan2(2, 4) - Math.atan2(1, tangent);
    assertCorner(tangent * Math.cos(toTheRight), tangent * Math.sin(toTheRight), pillar);
    double toTheLeft = Math.atan2(2, 4) + Math.atan2(1, tangent);
    assertCorner(tangent * Math.cos(toTheLeft), tangent * Math.sin(toTheLeft), pillar);
  }

  @Test
  void cornersInALineAreLeftOutAndNoOthers() {
    Obstacles wall = new Obstacles(List.of(new Obstacle.Wall(2, -1, 2, 1, 0)));
    List<Point> polygon = VisibleRegion.of(wall, 0, 0).polygon(4);
    double[] ends = {-1, 1};
    List<Point> on = polygon.stream().filter(p -> Math.abs(p.x() - 2) < 1e-6).toList();
    assertEquals(ends.length, on.stream().map(p -> Math.round(p.y())).distinct().count());
    assertTrue(on.size() <= 4, on.toString());
    assertTrue(polygon.size() > 200, polygon.size() + " corners: the reach is round");
  }

  private static void assertCorner(double x, double y, Obstacle... obstacles) {
    assertCorner(x, y, new Obstacles(List.of(obstacles)));
  }

  /** As seen from the origin. */
  private static void assertCorner(double x, double y, Obstacles obstacles) {
    List<Point> polygon = VisibleRegion.of(obstacles, 0, 0).polygon(REACH);
    double nearest =
        polygon.stream().mapToDouble(p -> Math.hypot(p.x() - x, p.y() - y)).min().orElseThrow();
    assertEquals(0, nearest, 1e-3, "a corner at (%s, %s)".formatted(x, y));
  }
}
