package org.hificamsim.tracks.place;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;

/** Makes obstacles of the shapes of a drawing. */
final class ObstacleMaker {
  private final List<Obstacle> obstacles = new ArrayList<>();

  List<Obstacle> make(List<DrawnPart> parts) {
    for (DrawnPart part : parts) {
      int first = obstacles.size();
      add(part.shape());
      for (int i = first; i < obstacles.size() && part.height() < Double.POSITIVE_INFINITY; i++) {
        obstacles.set(i, obstacles.get(i).between(0, part.height()));
      }
    }
    return obstacles;
  }

  private void add(DrawnShape shape) {
    if (shape instanceof DrawnShape.Line line) {
      addSides(line.corners());
    } else if (shape instanceof DrawnShape.Disc disc) {
      obstacles.add(new Obstacle.Pillar(disc.centre().x(), disc.centre().y(), disc.radius(), 0));
    } else if (shape instanceof DrawnShape.Area area) {
      add(area);
    }
  }

  private void add(DrawnShape.Area area) {
    List<Point> corners = corners(area.border());
    if (area.solid()) {
      addSolid(corners);
    } else {
      addRing(corners);
    }
    area.holes().forEach(hole -> addRing(corners(hole)));
  }

  /** Adds a solid polygon, or its sides if they cross each other; a single point adds nothing. */
  private void addSolid(List<Point> corners) {
    if (corners.size() < 2) {
      return;
    }
    try {
      obstacles.add(new Obstacle.Polygon(corners, 0));
    } catch (IllegalArgumentException e) {
      addRing(corners);
    }
  }

  private void addRing(List<Point> corners) {
    List<Point> ring = new ArrayList<>(corners);
    if (!ring.isEmpty()) {
      ring.add(ring.get(0));
    }
    addSides(ring);
  }

  /** Adds walls between consecutive points, except between equal ones. */
  private void addSides(List<Point> points) {
    for (int i = 1; i < points.size(); i++) {
      Point from = points.get(i - 1);
      Point to = points.get(i);
      if (!from.equals(to)) {
        obstacles.add(new Obstacle.Wall(from.x(), from.y(), to.x(), to.y(), 0));
      }
    }
  }

  /** The points of a border without repetitions and without the first one at the end. */
  static List<Point> corners(List<Point> border) {
    List<Point> corners = new ArrayList<>();
    for (Point point : border) {
      if (corners.isEmpty() || !corners.get(corners.size() - 1).equals(point)) {
        corners.add(point);
      }
    }
    if (corners.size() > 1 && corners.get(0).equals(corners.get(corners.size() - 1))) {
      corners.remove(corners.size() - 1);
    }
    return corners;
  }
}
