package org.hificamsim.placement.site;

import static org.hificamsim.core.NamedSetting.setting;

import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.data.CsvReader;
import org.hificamsim.data.CsvRow;

/**
 * The points where cameras can be mounted: along both sides of walls, around polygons and pillars,
 * along the border of the field, on the ceiling, or at listed points.
 */
public final class MountPoints {
  /** The distance of a camera from what it is mounted on, metres. */
  private static final double CLEARANCE = 0.2;

  private static final double MAX_COORDINATE = 1e9;

  private final Field field;
  private final Obstacles obstacles;
  private final List<Zone> forbidden;
  private final Set<Point> points = new LinkedHashSet<>();

  private MountPoints(Scenario site, List<Zone> forbidden) {
    this.field = site.field();
    this.obstacles = new Obstacles(site.obstacles());
    this.forbidden = forbidden;
  }

  /**
   * Returns the points on a site.
   *
   * @param spacing metres from one point to the next, above 0
   * @param ceiling whether to add a grid of points all over the field
   * @param forbidden zones in which no camera may be
   * @throws InputException if there is no such point
   */
  public static List<Point> of(
      Scenario site, double spacing, boolean ceiling, List<Zone> forbidden) {
    MountPoints mounts = new MountPoints(site, forbidden);
    Field field = mounts.field;
    mounts.addAround(
        List.of(
            new Point(field.minX(), field.minY()),
            new Point(field.maxX(), field.minY()),
            new Point(field.maxX(), field.maxY()),
            new Point(field.minX(), field.maxY())),
        spacing);
    for (Obstacle obstacle : site.obstacles()) {
      if (obstacle instanceof Obstacle.Wall wall) {
        mounts.addAlong(new Point(wall.x1(), wall.y1()), new Point(wall.x2(), wall.y2()), spacing);
      } else if (obstacle instanceof Obstacle.Polygon polygon) {
        mounts.addAround(polygon.points(), spacing);
      } else if (obstacle instanceof Obstacle.Pillar pillar) {
        mounts.addAround(pillar, spacing);
      }
    }
    for (double x = field.minX() + spacing / 2; ceiling && x < field.maxX(); x += spacing) {
      for (double y = field.minY() + spacing / 2; y < field.maxY(); y += spacing) {
        mounts.add(x, y);
      }
    }
    return mounts.nonEmpty(
        setting("candidates")
            + " closer together, or fewer zones that "
            + setting("forbid")
            + " names");
  }

  /**
   * Reads the points from a table with the columns x and y, metres.
   *
   * @throws InputException if there is no point, or one where no camera can be, with line and
   *     column
   */
  public static List<Point> read(Path file, Scenario site, List<Zone> forbidden) {
    MountPoints mounts = new MountPoints(site, forbidden);
    for (CsvRow row :
        CsvReader.open(file, "a table of x and y").readAll(List.of("x", "y")).rows()) {
      double x = row.number("x", -MAX_COORDINATE, MAX_COORDINATE, "a number");
      double y = row.number("y", -MAX_COORDINATE, MAX_COORDINATE, "a number");
      if (!mounts.add(x, y) && !mounts.points.contains(new Point(x, y))) {
        throw row.invalid("x", "a place in the field, off obstacles and forbidden zones");
      }
    }
    return mounts.nonEmpty("a place in " + file);
  }

  private List<Point> nonEmpty(String expected) {
    if (points.isEmpty()) {
      throw new InputException("no camera can be mounted anywhere, expected " + expected);
    }
    return List.copyOf(points);
  }

  private void addAround(List<Point> corners, double spacing) {
    for (int i = 0; i < corners.size(); i++) {
      addAlong(corners.get(i), corners.get((i + 1) % corners.size()), spacing);
    }
  }

  private void addAround(Obstacle.Pillar pillar, double spacing) {
    double radius = pillar.radius() + CLEARANCE;
    int count = Math.max(4, (int) Math.round(2 * Math.PI * radius / spacing));
    for (int i = 0; i < count; i++) {
      double angle = 2 * Math.PI * i / count;
      add(pillar.x() + radius * Math.cos(angle), pillar.y() + radius * Math.sin(angle));
    }
  }

  /** Adds points on both sides of a line, from one end to the other. */
  private void addAlong(Point from, Point to, double spacing) {
    double dx = to.x() - from.x();
    double dy = to.y() - from.y();
    double length = Math.hypot(dx, dy);
    int parts = Math.max(1, (int) Math.round(length / spacing));
    for (int i = 0; i <= parts && length > 0; i++) {
      double endDistance = Math.min(CLEARANCE, length / 2); // the ends may be in corners
      double distance = Math.max(endDistance, Math.min(length - endDistance, i * length / parts));
      double along = distance / length;
      for (int side = -1; side <= 1; side += 2) {
        add(
            from.x() + along * dx - side * CLEARANCE * dy / length,
            from.y() + along * dy + side * CLEARANCE * dx / length);
      }
    }
  }

  /** Adds a point, rounded to centimetres, if it is new and a camera can be there. */
  private boolean add(double exactX, double exactY) {
    double x = Math.rint(100 * exactX) / 100;
    double y = Math.rint(100 * exactY) / 100;
    Point point = new Point(x, y);
    boolean allowed =
        field.contains(x, y)
            && obstacles.containing(x, y).isEmpty()
            && forbidden.stream().noneMatch(zone -> zone.contains(x, y));
    return allowed && points.add(point);
  }
}
