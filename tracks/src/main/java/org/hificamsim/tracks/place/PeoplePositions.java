package org.hificamsim.tracks.place;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.spec.Field;

/** Positions that people take, thinned out evenly to at most 1,000. */
public final class PeoplePositions {
  private static final int MAX_POINTS = 1_000;

  /** The number of points along the longer side of a grid. */
  private static final int GRID = 24;

  private final List<Point> points = new ArrayList<>();
  private int stride = 1;
  private int skipped;

  /** Returns a way that has every free part of a field. */
  public static PeoplePositions allOver(Field field, Obstacles obstacles) {
    PeoplePositions way = new PeoplePositions();
    double step = Math.max(field.width(), field.height()) / GRID;
    for (double y = field.minY() + step / 2; y < field.maxY(); y += step) {
      for (double x = field.minX() + step / 2; x < field.maxX(); x += step) {
        if (obstacles.containing(x, y).isEmpty()) {
          way.add(x, y);
        }
      }
    }
    return way;
  }

  /** Adds a position, in metres. */
  public void add(double x, double y) {
    if (skipped++ % stride == 0) {
      points.add(new Point(x, y));
    }
    if (points.size() > MAX_POINTS) {
      keepEverySecond();
    }
  }

  private void keepEverySecond() {
    for (int i = 0; 2 * i < points.size(); i++) {
      points.set(i, points.get(2 * i));
    }
    points.subList((points.size() + 1) / 2, points.size()).clear();
    stride *= 2;
    skipped = 0;
  }

  /** The positions that were kept. */
  public List<Point> points() {
    return Collections.unmodifiableList(points);
  }
}
