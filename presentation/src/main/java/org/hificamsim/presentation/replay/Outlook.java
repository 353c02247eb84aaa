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
 * Computes the region that no solid obstacle hides from a camera, as corners to be drawn. The
 * region is a disc around the camera without the shadows of walls, pillars, and sides of polygons.
 */
final class Outlook {
  /**
   * The ratio of the disc's radius and the camera's reach. It is above 1, so that a disc with few
   * corners contains all that is in reach.
   */
  private static final double DISC_FACTOR = 1.1;

  // the numbers of corners of a quarter of a circle
  private static final int DISC_CORNERS = 6;
  private static final int PILLAR_CORNERS = 12;

  private static final GeometryFactory SHAPES = new GeometryFactory();

  /** The precision of corners, a micrometre, because cutting fails for unrounded ones. */
  private static final PrecisionModel GRID = new PrecisionModel(1e6);

  private final List<Obstacle> obstacles;
  private final Map<Double, Obstacles> opaqueByHeight = new HashMap<>();
  private final Scale scale;

  Outlook(List<Obstacle> obstacles, Field field) {
    this.obstacles = obstacles;
    this.scale = Scale.of(field);
  }

  /**
   * Returns the corners in the form of {@link CameraPose#visible}. A camera in an obstacle sees its
   * own place only.
   *
   * @param z the height of the camera, in metres; NaN in a flat world
   * @param reach the reach of the camera, in metres
   */
  List<Double> from(double x, double y, double z, double reach) {
    Obstacles walls = opaqueByHeight.computeIfAbsent(z, this::opaque);
    if (walls.isEmpty() || !(reach > 0)) {
      return List.of();
    }
    Coordinate camera = new Coordinate(x, y);
    return walls.containing(x, y).isPresent()
        ? List.of(rounded(x), rounded(y))
        : rounded(visible(walls.all(), camera, DISC_FACTOR * reach));
  }

  /** Returns the obstacles that a camera at a height cannot look over, without their tops. */
  private Obstacles opaque(double z) {
    return new Obstacles(
        obstacles.stream()
            .filter(Obstacle::solid)
            .filter(obstacle -> obstacle.full() || (obstacle.base() == 0 && obstacle.height() >= z))
            .map(obstacle -> obstacle.between(0, Double.POSITIVE_INFINITY))
            .toList());
  }

  /** Returns the border of the visible region, counterclockwise. */
  private static List<Coordinate> visible(List<Obstacle> walls, Coordinate camera, double reach) {
    Geometry disc = disc(camera.x, camera.y, reach, DISC_CORNERS);
    List<Geometry> shadows =
        walls.stream()
            .flatMap(Outlook::parts)
            .filter(part -> part.distance(SHAPES.createPoint(camera)) <= reach)
            .map(part -> shadow(part.getCoordinates(), camera, reach))
            .filter(shadow -> shadow.getDimension() == 2) // a wall seen end on has none
            .toList();
    Geometry visible =
        shadows.isEmpty()
            ? disc
            : OverlayNG.overlay(
                disc, UnaryUnionNG.union(shadows, GRID), OverlayNG.DIFFERENCE, GRID);
    Geometry largest = // rounding may leave tiny other parts
        IntStream.range(0, visible.getNumGeometries())
            .mapToObj(visible::getGeometryN)
            .max(Comparator.comparingDouble(Geometry::getArea))
            .orElseThrow();
    Coordinate[] border = ((Polygon) largest.norm()).getExteriorRing().reverse().getCoordinates();
    return Arrays.asList(border).subList(1, border.length);
  }

  private static Geometry disc(double x, double y, double radius, int corners) {
    return SHAPES.createPoint(new Coordinate(x, y)).buffer(radius, corners);
  }

  /** Returns convex parts of an obstacle that hide the same as the whole obstacle. */
  private static Stream<Geometry> parts(Obstacle obstacle) {
    if (obstacle instanceof Obstacle.Pillar pillar) {
      return Stream.of(disc(pillar.x(), pillar.y(), pillar.radius(), PILLAR_CORNERS));
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

  /**
   * Returns the shadow of a convex part: the part itself, and the area behind it beyond the reach.
   */
  private static Geometry shadow(Coordinate[] corners, Coordinate camera, double reach) {
    double far = 2 * reach + Arrays.stream(corners).mapToDouble(camera::distance).max().orElse(0);
    Vector2D first = Vector2D.create(camera, corners[0]).normalize();
    Vector2D last = Vector2D.create(camera, corners[corners.length - 1]).normalize();
    Vector2D middle = first.add(last);
    if (middle.length() < 1e-6) { // the camera is at the side, whose shadow is half a turn wide
      int side = Orientation.index(corners[0], corners[1], camera);
      middle = Vector2D.create(corners[0], corners[1]).rotateByQuarterCircle(-side);
    }
    Stream<Vector2D> directions =
        Stream.concat(
            Stream.of(middle),
            Arrays.stream(corners).map(corner -> Vector2D.create(camera, corner)));
    return SHAPES
        .createMultiPointFromCoords(
            Stream.concat(
                    Arrays.stream(corners),
                    directions.map(
                        direction -> direction.normalize().multiply(4 * far).translate(camera)))
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
