package org.hificamsim.placement.site;

import static org.hificamsim.core.NamedSetting.setting;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
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
 * Where cameras can be mounted: along both sides of walls, round polygons and pillars, along the
 * field's border, on the ceiling, or at listed places.
 */
public final class MountPoints {
  private static final double CLEARANCE = 0.2; // metres off what it is mounted on
  private static final double FARTHEST = 1e9;

  private final Field field;
  private final Obstacles obstacles;
  private final List<Zone> forbidden;
  private final List<Point> points = new ArrayList<>();

  private MountPoints(Scenario site, List<Zone> forbidden) {
    this.field = site.field();
    this.obstacles = new Obstacles(site.obstacles());
    this.forbidden = forbidden;
  }

  /**
   * The places on a site.
   *
   * @param every metres from one to the next, above 0
   * @param ceiling whether a grid of places all over the field is among them
   * @param forbidden zones in which no camera may be
   * @throws InputException where there is none
   */
  public static List<Point> of(Scenario site, double every, boolean ceiling, List<Zone> forbidden) {
    MountPoints mounts = new MountPoints(site, forbidden);
    Field field = mounts.field;
    mounts.addRound(
        List.of(
            new Point(field.minX(), field.minY()),
            new Point(field.maxX(), field.minY()),
            new Point(field.maxX(), field.maxY()),
            new Point(field.minX(), field.maxY())),
        every);
    for (Obstacle obstacle : site.obstacles()) {
      if (obstacle instanceof Obstacle.Wall wall) {
        mounts.addAlong(new Point(wall.x1(), wall.y1()), new Point(wall.x2(), wall.y2()), every);
      } else if (obstacle instanceof Obstacle.Polygon polygon) {
        mounts.addRound(polygon.points(), every);
      } else if (obstacle instanceof Obstacle.Pillar pillar) {
        mounts.addRound(pillar, every);
      }
    }
    for (double x = field.minX() + every / 2; ceiling && x < field.maxX(); x += every) {
      for (double y = field.minY() + every / 2; y < field.maxY(); y += every) {
        mounts.add(x, y);
      }
    }
    return mounts.some(
        setting("candidates")
            + " closer together, or fewer zones that "
            + setting("forbid")
            + " names");
  }

  /**
   * The places in a table with the columns x and y, metres.
   *
   * @throws InputException where there is none, or one where no camera can be, with its place
   */
  public static List<Point> read(Path file, Scenario site, List<Zone> forbidden) {
    MountPoints mounts = new MountPoints(site, forbidden);
    for (CsvRow row : CsvReader.open(file, "a table of x and y").all(List.of("x", "y")).rows()) {
      double x = row.number("x", -FARTHEST, FARTHEST, "a number");
      double y = row.number("y", -FARTHEST, FARTHEST, "a number");
      if (!mounts.add(x, y) && !mounts.points.contains(new Point(x, y))) {
        throw row.invalid("x", "a place in the field, off obstacles and forbidden zones");
      }
    }
    return mounts.some("a place in " + file);
  }

  private List<Point> some(String expected) {
    if (points.isEmpty()) {
      throw new InputException("no camera can be mounted anywhere, expected " + expected);
    }
    return points;
  }

  private void addRound(List<Point> corners, double every) {
    for (int i = 0; i < corners.size(); i++) {
      addAlong(corners.get(i), corners.get((i + 1) % corners.size()), every);
    }
  }

  private void addRound(Obstacle.Pillar pillar, double every) {
    double radius = pillar.radius() + CLEARANCE;
    int count = Math.max(4, (int) Math.round(2 * Math.PI * radius / every));
    for (int i = 0; i < count; i++) {
      double angle = 2 * Math.PI * i / count;
      add(pillar.x() + radius * Math.cos(angle), pillar.y() + radius * Math.sin(angle));
    }
  }

  /** On both sides, from one end to the other. */
  private void addAlong(Point from, Point to, double every) {
    double dx = to.x() - from.x();
    double dy = to.y() - from.y();
    double length = Math.hypot(dx, dy);
    int parts = Math.max(1, (int) Math.round(length / every));
    for (int i = 0; i <= parts && length > 0; i++) {
      double off = Math.min(CLEARANCE, length / 2); // the ends are in corners
      double along = Math.max(off, Math.min(length - off, i * length / parts)) / length;
      for (int side = -1; side <= 1; side += 2) {
        add(
            from.x() + along * dx - side * CLEARANCE * dy / length,
            from.y() + along * dy + side * CLEARANCE * dx / length);
      }
    }
  }

  /** Adds a place, to the centimetre, if a camera can be there and none is. */
  private boolean add(double atX, double atY) {
    double x = Math.rint(100 * atX) / 100;
    double y = Math.rint(100 * atY) / 100;
    Point point = new Point(x, y);
    boolean allowed =
        field.contains(x, y)
            && obstacles.containing(x, y).isEmpty()
            && forbidden.stream().noneMatch(zone -> zone.contains(x, y))
            && !points.contains(point);
    return allowed && points.add(point);
  }
}
