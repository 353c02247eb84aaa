package org.hificamsim.presentation.replay;

import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.spec.Field;
import org.locationtech.jts.algorithm.Orientation;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.geom.PrecisionModel;
import org.locationtech.jts.math.Vector2D;
import org.locationtech.jts.operation.overlayng.OverlayNG;
import org.locationtech.jts.operation.overlayng.UnaryUnionNG;

/**
 * What solid obstacles leave in sight, as corners to be drawn: a disc about the camera, with the
 * shadows of walls, sides and pillars cut out.
 */
final class Outlook {
  /** Beyond what a camera reaches, so that few corners do where nothing is in the way. */
  private static final double BEYOND = 1.1;

  // Corners of a quarter of a circle.
  private static final int OF_DISC = 6;
  private static final int OF_PILLAR = 12;

  private static final GeometryFactory SHAPES = new GeometryFactory();

  /** All corners come to lie on it, of a micrometre: cutting fails where rounding is left open. */
  private static final PrecisionModel GRID = new PrecisionModel(1e6);

  private final List<Obstacle> obstacles;
  private final Map<Double, Obstacles> hiding = new HashMap<>(); // by a camera's height
  private final Scale scale;

  Outlook(List<Obstacle> obstacles, Field field) {
    this.obstacles = obstacles;
    this.scale = Scale.of(field);
  }

  /**
   * The corners as in {@link CameraPose#visible}; the place itself where a camera sees nothing.
   *
   * @param z of the camera, metres; NaN in a flat world
   * @param reach of the camera, metres
   */
  List<Double> from(double x, double y, double z, double reach) {
    Obstacles walls = hiding.computeIfAbsent(z, this::hiding);
    if (walls.isEmpty() || !(reach > 0)) {
      return List.of();
    }
    Coordinate at = new Coordinate(x, y);
    return walls.containing(x, y).isPresent()
        ? List.of(rounded(x), rounded(y))
        : rounded(seen(walls.all(), at, BEYOND * reach));
  }

  /** Those that a camera cannot look over, as if they had no top. */
  private Obstacles hiding(double z) {
    return new Obstacles(
        obstacles.stream()
            .filter(one -> one.solid() && (one.full() || (one.base() == 0 && one.height() >= z)))
            .map(one -> one.between(0, Double.POSITIVE_INFINITY))
            .toList());
  }

  /** The border of what is seen, counterclockwise. */
  private static List<Coordinate> seen(List<Obstacle> walls, Coordinate at, double reach) {
    Geometry disc = disc(at.x, at.y, reach, OF_DISC);
    List<Geometry> shadows =
        walls.stream()
            .flatMap(Outlook::parts)
            .filter(part -> part.distance(SHAPES.createPoint(at)) <= reach)
            .map(part -> shadow(part.getCoordinates(), at, reach))
            .filter(shadow -> shadow.getDimension() == 2) // what is seen end on has none
            .toList();
    Geometry seen =
        shadows.isEmpty()
            ? disc
            : OverlayNG.overlay(
                disc, UnaryUnionNG.union(shadows, GRID), OverlayNG.DIFFERENCE, GRID);
    Geometry around = // all of it, but for crumbs
        IntStream.range(0, seen.getNumGeometries())
            .mapToObj(seen::getGeometryN)
            .max(Comparator.comparingDouble(Geometry::getArea))
            .orElseThrow();
    Coordinate[] border = ((Polygon) around.norm()).getExteriorRing().reverse().getCoordinates();
    return Arrays.asList(border).subList(1, border.length);
  }

  private static Geometry disc(double x, double y, double radius, int corners) {
    return SHAPES.createPoint(new Coordinate(x, y)).buffer(radius, corners);
  }

  /** What of an obstacle hides something, in convex parts. */
  private static Stream<Geometry> parts(Obstacle obstacle) {
    if (obstacle instanceof Obstacle.Pillar pillar) {
      return Stream.of(disc(pillar.x(), pillar.y(), pillar.radius(), OF_PILLAR));
    }
    if (obstacle instanceof Obstacle.Wall wall) {
      return Stream.of(side(wall.x1(), wall.y1(), wall.x2(), wall.y2()));
    }
    List<Point> corners = ((Obstacle.Polygon) obstacle).points();
    return IntStream.range(0, corners.size())
        .mapToObj(
            i -> {
              Point from = corners.get(i);
              Point to = corners.get((i + 1) % corners.size());
              return side(from.x(), from.y(), to.x(), to.y());
            });
  }

  private static Geometry side(double x1, double y1, double x2, double y2) {
    return SHAPES.createLineString(
        new Coordinate[] {new Coordinate(x1, y1), new Coordinate(x2, y2)});
  }

  /** A convex part and what is behind it, beyond the reach. */
  private static Geometry shadow(Coordinate[] corners, Coordinate at, double reach) {
    double far = 2 * reach + Arrays.stream(corners).mapToDouble(at::distance).max().orElse(0);
    Vector2D one = Vector2D.create(at, corners[0]).normalize();
    Vector2D other = Vector2D.create(at, corners[corners.length - 1]).normalize();
    Vector2D middle = one.add(other);
    if (middle.length() < 1e-6) { // a side as good as beside the camera: half a turn wide
      int side = Orientation.index(corners[0], corners[1], at);
      middle = Vector2D.create(corners[0], corners[1]).rotateByQuarterCircle(-side);
    }
    Stream<Vector2D> behind =
        Stream.concat(
            Stream.of(middle), Arrays.stream(corners).map(corner -> Vector2D.create(at, corner)));
    return SHAPES
        .createMultiPointFromCoords(
            Stream.concat(
                    Arrays.stream(corners),
                    behind.map(way -> way.normalize().multiply(4 * far).translate(at)))
                .toArray(Coordinate[]::new))
        .convexHull();
  }

  private List<Double> rounded(List<Coordinate> corners) {
    return corners.stream()
        .flatMap(corner -> Stream.of(rounded(corner.x), rounded(corner.y)))
        .toList();
  }

  private double rounded(double metres) {
    return scale.unpack(scale.pack(metres));
  }
}
