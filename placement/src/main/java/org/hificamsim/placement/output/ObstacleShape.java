package org.hificamsim.placement.output;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.List;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.spec.Zone;

/** Draws obstacles, and outlines zones, on pictures of a plan. */
final class ObstacleShape {
  private static final BasicStroke WALL = new BasicStroke(2);

  private ObstacleShape() {}

  /**
   * Paints an obstacle: a wall as a line, others as filled shapes.
   *
   * @param toPaper the transform from metres on the site to points of the picture
   */
  static void paint(Graphics2D graphics, Obstacle obstacle, AffineTransform toPaper) {
    if (obstacle instanceof Obstacle.Wall wall) {
      graphics.setStroke(WALL);
      Line2D line = new Line2D.Double(wall.x1(), wall.y1(), wall.x2(), wall.y2());
      graphics.draw(toPaper.createTransformedShape(line));
    } else if (obstacle instanceof Obstacle.Polygon polygon) {
      graphics.fill(toPaper.createTransformedShape(path(polygon.points(), true)));
    } else if (obstacle instanceof Obstacle.Pillar pillar) {
      double radius = pillar.radius();
      Shape circle =
          new Ellipse2D.Double(pillar.x() - radius, pillar.y() - radius, 2 * radius, 2 * radius);
      graphics.fill(toPaper.createTransformedShape(circle));
    }
  }

  /** Returns the outline of a zone in metres. It is empty if the zone is the whole field. */
  static Path2D outline(Zone zone) {
    List<Point> points = zone.points();
    return switch (zone.shape()) {
      case FIELD -> new Path2D.Double();
      case POLYGON -> path(points, true);
      case POLYLINE -> path(points, false);
      case RECTANGLE -> rectangle(points.get(0), points.get(1));
    };
  }

  private static Path2D rectangle(Point corner, Point opposite) {
    return path(
        List.of(
            corner,
            new Point(opposite.x(), corner.y()),
            opposite,
            new Point(corner.x(), opposite.y())),
        true);
  }

  private static Path2D path(List<Point> points, boolean closed) {
    Path2D path = new Path2D.Double();
    path.moveTo(points.get(0).x(), points.get(0).y());
    points.stream().skip(1).forEach(point -> path.lineTo(point.x(), point.y()));
    if (closed) {
      path.closePath();
    }
    return path;
  }
}
