package org.hificamsim.presentation.picture;

import java.awt.Shape;
import java.awt.geom.Arc2D;
import java.awt.geom.Area;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.presentation.replay.CameraPose;

/**
 * Where metres are in a picture: to scale, y upwards.
 *
 * @param scale points per metre
 * @param left x of the field's origin, points
 * @param top y of the field's origin, points
 */
record FieldMap(double scale, double left, double top) {
  /** Room about the field, for what cameras see beyond it; a share of its longer side. */
  private static final double MARGIN = 0.06;

  /** A field with no room at all is shown as a small one. */
  private static final double SMALLEST = 1e-3;

  /** The whole field within a rectangle of the picture. */
  static FieldMap fit(Field field, Rectangle2D area) {
    double scale = Math.min(area.getWidth() / width(field), area.getHeight() / height(field));
    return new FieldMap(
        scale,
        area.getCenterX() - scale * (field.minX() + field.maxX()) / 2,
        area.getCenterY() + scale * (field.minY() + field.maxY()) / 2);
  }

  /** The width of the field with room about it, metres. */
  static double width(Field field) {
    return field.width() + 2 * room(field);
  }

  /** The height of the field with room about it, metres. */
  static double height(Field field) {
    return field.height() + 2 * room(field);
  }

  private static double room(Field field) {
    return MARGIN * Math.max(SMALLEST, Math.max(field.width(), field.height()));
  }

  double x(double metres) {
    return left + scale * metres;
  }

  double y(double metres) {
    return top - scale * metres;
  }

  Rectangle2D rectangle(Field field) {
    return new Rectangle2D.Double(
        x(field.minX()), y(field.maxY()), scale * field.width(), scale * field.height());
  }

  /** A sector or a full circle about a camera in a view; headings run clockwise from +y. */
  Shape sector(CameraPose pose, int view, double radius) {
    double r = scale * radius;
    double x = x(pose.x()) - r;
    double y = y(pose.y()) - r;
    if (pose.viewingAngle(view) >= 2 * Math.PI) {
      return new Ellipse2D.Double(x, y, 2 * r, 2 * r);
    }
    double middle = 90 - Math.toDegrees(pose.heading(view));
    double extent = Math.toDegrees(pose.viewingAngle(view));
    return new Arc2D.Double(x, y, 2 * r, 2 * r, middle - extent / 2, extent, Arc2D.PIE);
  }

  /** The part of a view between two distances that is in sight, metres. */
  Area band(CameraPose pose, int view, double from, double to) {
    Area band = new Area(sector(pose, view, to));
    band.subtract(new Area(sector(pose, view, from)));
    if (!pose.visible().isEmpty()) {
      band.intersect(new Area(ring(pose.visible())));
    }
    return band;
  }

  /** Corners that are x and y in turn, metres, joined to a ring. */
  Shape ring(List<Double> corners) {
    Path2D path = new Path2D.Double();
    for (int i = 0; i < corners.size(); i += 2) {
      double x = x(corners.get(i));
      double y = y(corners.get(i + 1));
      if (i == 0) {
        path.moveTo(x, y);
      } else {
        path.lineTo(x, y);
      }
    }
    path.closePath();
    return path;
  }

  /** An obstacle: a wall as a line, others as areas. */
  Shape shape(Obstacle obstacle) {
    if (obstacle instanceof Obstacle.Wall wall) {
      return new Line2D.Double(x(wall.x1()), y(wall.y1()), x(wall.x2()), y(wall.y2()));
    }
    if (obstacle instanceof Obstacle.Pillar pillar) {
      double r = scale * pillar.radius();
      return new Ellipse2D.Double(x(pillar.x()) - r, y(pillar.y()) - r, 2 * r, 2 * r);
    }
    List<Point> points = ((Obstacle.Polygon) obstacle).points();
    return ring(points.stream().flatMap(p -> Stream.of(p.x(), p.y())).toList());
  }
}
