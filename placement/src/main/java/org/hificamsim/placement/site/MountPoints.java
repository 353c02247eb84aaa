package org.hificamsim.placement.site;

import static org.hificamsim.core.NamedSetting.setting;

import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.data.CsvReader;
import org.hificamsim.data.CsvRow;

/**
 * Finds the points where cameras can be mounted: along both sides of walls, around polygons and
 * pillars, along the border of the field, on the ceiling, or at listed points. On a site with
 * heights, only obstacles that reach the height of the cameras count. No camera hangs in a door or
 * another narrow gap. If all zones are inside a building, no camera hangs outside or on the border.
 */
public final class MountPoints {
  /** The usual distance of a camera from what it is mounted on, in metres. */
  public static final double CLEARANCE = 0.2;

  private static final double MAX_COORDINATE = 1e9;

  /** The width of the widest gap that is a door, in metres. */
  private static final double MAX_DOOR = 2.5;

  /** The thickness of the thickest wall in which doors are, in metres. */
  private static final double MAX_THICKNESS = 0.6;

  /**
   * Rules by which cameras are mounted.
   *
   * @param spacing the distance from one point to the next, in metres, above 0
   * @param clearance the distance of a camera from the surface that it is mounted on, and the least
   *     one from everything else, in metres, above 0
   * @param ceiling whether to add a grid of points all over the field
   * @param forbidden zones in which no camera may be
   */
  public record Rules(double spacing, double clearance, boolean ceiling, List<Zone> forbidden) {}

  private final Field field;
  private final MountObstacles obstacles;
  private final Rules rules;
  private final Optional<Enclosure> building;
  private final Set<Point> points = new LinkedHashSet<>();

  private MountPoints(Scenario site, Rules rules, List<Zone> zones) {
    field = site.field();
    obstacles = new MountObstacles(site);
    this.rules = rules;
    building = obstacles.enclosure(zones);
  }

  /**
   * Returns the points on a site.
   *
   * @throws InputException if there is no such point
   */
  public static List<Point> of(Scenario site, Rules rules) {
    MountPoints mounts = new MountPoints(site, rules, site.zones());
    double spacing = rules.spacing;
    Field field = mounts.field;
    if (mounts.building.isEmpty()) {
      mounts.addAround(corners(field));
    }
    for (Obstacle obstacle : mounts.obstacles.list()) {
      if (obstacle instanceof Obstacle.Wall wall) {
        mounts.addAlong(
            new Point(wall.x1(), wall.y1()), new Point(wall.x2(), wall.y2()), mounts.slot());
      } else if (obstacle instanceof Obstacle.Polygon polygon) {
        mounts.addAround(polygon.points());
      } else if (obstacle instanceof Obstacle.Pillar pillar) {
        mounts.addAround(pillar);
      }
    }
    for (double x = field.minX() + spacing / 2; rules.ceiling && x < field.maxX(); x += spacing) {
      for (double y = field.minY() + spacing / 2; y < field.maxY(); y += spacing) {
        mounts.add(x, y);
      }
    }
    return mounts.requireAny(
        setting("candidates")
            + " closer together, or fewer zones that "
            + setting("forbid")
            + " names, or obstacles as high as the cameras");
  }

  private static List<Point> corners(Field field) {
    return List.of(
        new Point(field.minX(), field.minY()),
        new Point(field.maxX(), field.minY()),
        new Point(field.maxX(), field.maxY()),
        new Point(field.minX(), field.maxY()));
  }

  /**
   * Reads the points from a table with the columns x and y, in metres.
   *
   * @throws InputException if there is no point, or one where no camera can be, with line and
   *     column
   */
  public static List<Point> read(Path file, Scenario site, List<Zone> forbidden) {
    MountPoints mounts = new MountPoints(site, new Rules(1, 0, false, forbidden), List.of());
    for (CsvRow row :
        CsvReader.open(file, "a table of x and y").readAll(List.of("x", "y")).rows()) {
      double x = row.number("x", -MAX_COORDINATE, MAX_COORDINATE, "a number");
      double y = row.number("y", -MAX_COORDINATE, MAX_COORDINATE, "a number");
      if (!mounts.add(x, y) && !mounts.points.contains(new Point(x, y))) {
        throw row.invalid("x", "a place in the field, off obstacles and forbidden zones");
      }
    }
    return mounts.requireAny("a place in " + file);
  }

  private List<Point> requireAny(String expected) {
    if (points.isEmpty()) {
      throw new InputException("no camera can be mounted anywhere, expected " + expected);
    }
    return List.copyOf(points);
  }

  /** Returns the width of a gap between two obstacles that has no room for a camera, in metres. */
  private double slot() {
    return 3 * rules.clearance;
  }

  private void addAround(List<Point> corners) {
    for (int i = 0; i < corners.size(); i++) {
      Point from = corners.get(i);
      Point to = corners.get((i + 1) % corners.size());
      addAlong(from, to, isEndOfWall(corners, i) ? widestDoor() : slot());
    }
  }

  /** The width of the widest door, in metres: in a building, of its widest entrance. */
  private double widestDoor() {
    return building.isPresent() ? Enclosure.MAX_ENTRANCE : MAX_DOOR;
  }

  /** Whether an edge is the end of a thick wall, as at a door. */
  private static boolean isEndOfWall(List<Point> corners, int edge) {
    double length = length(corners, edge);
    double before = length(corners, edge + corners.size() - 1);
    double after = length(corners, edge + 1);
    return length <= MAX_THICKNESS && Math.min(before, after) >= 2 * length;
  }

  private static double length(List<Point> corners, int edge) {
    Point from = corners.get(edge % corners.size());
    Point to = corners.get((edge + 1) % corners.size());
    return Math.hypot(to.x() - from.x(), to.y() - from.y());
  }

  private void addAround(Obstacle.Pillar pillar) {
    double radius = pillar.radius() + rules.clearance;
    int count = Math.max(4, (int) Math.round(2 * Math.PI * radius / rules.spacing));
    for (int i = 0; i < count; i++) {
      double angle = 2 * Math.PI * i / count;
      add(pillar.x() + radius * Math.cos(angle), pillar.y() + radius * Math.sin(angle));
    }
  }

  /**
   * Adds points on both sides of a line, from one end to the other.
   *
   * @param room the distance in front of a camera in which no obstacle may be, in metres
   */
  private void addAlong(Point from, Point to, double room) {
    double clearance = rules.clearance;
    double dx = to.x() - from.x();
    double dy = to.y() - from.y();
    double length = Math.hypot(dx, dy);
    int parts = Math.max(1, (int) Math.round(length / rules.spacing));
    for (int i = 0; i <= parts && length > 0; i++) {
      double endDistance = Math.min(clearance, length / 2); // the ends may be in corners
      double distance = Math.max(endDistance, Math.min(length - endDistance, i * length / parts));
      double along = distance / length;
      Point base = new Point(from.x() + along * dx, from.y() + along * dy);
      for (int side = -1; side <= 1; side += 2) {
        Point normal = new Point(-side * dy / length, side * dx / length);
        Point position = ahead(base, normal, clearance);
        if (!obstacles.isBetween(ahead(base, normal, clearance / 2), ahead(base, normal, room))) {
          add(position.x(), position.y());
        }
      }
    }
  }

  private static Point ahead(Point from, Point direction, double distance) {
    return new Point(from.x() + distance * direction.x(), from.y() + distance * direction.y());
  }

  /** Adds a point, rounded to centimetres, if it is new and a camera can be there. */
  private boolean add(double exactX, double exactY) {
    double x = Math.rint(100 * exactX) / 100;
    double y = Math.rint(100 * exactY) / 100;
    Point point = new Point(x, y);
    boolean allowed =
        field.contains(x, y)
            && obstacles.isFree(point, rules.clearance)
            && building.filter(walls -> !walls.contains(point)).isEmpty()
            && rules.forbidden.stream().noneMatch(zone -> zone.contains(x, y));
    return allowed && points.add(point);
  }
}
