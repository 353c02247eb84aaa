package org.hificamsim.tracks.place;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.DraftOptics;
import org.hificamsim.core.scenario.spec.Field;

/**
 * A first draft of cameras: domes at equal distances along the border of the field, from its lower
 * left corner, that look at its middle. If walls have heights, cameras hang at 3 m and look down. A
 * camera that would be in a wall is moved along the border. One to which walls hide the way of
 * people is moved towards the middle, to where it sees most of them, and looks at these.
 */
public final class DraftCameras {
  /** The distance from the border, as a share of the field's shorter side. */
  private static final double INSET = 0.01;

  private static final int TRIES = 400;

  /** The number of positions between the border and the middle. */
  private static final int RINGS = 40;

  private final Field field;
  private final Obstacles obstacles;
  private final Way way;
  private final boolean flat;
  private final List<CameraSpec> cameras = new ArrayList<>();

  /**
   * @param way positions of people that cameras should see
   * @param count of cameras
   */
  public DraftCameras(Field field, Obstacles obstacles, Way way, int count) {
    this.field = field;
    this.obstacles = obstacles;
    this.way = way;
    this.flat = obstacles.all().stream().allMatch(Obstacle::full);
    for (int i = 0; i < count; i++) {
      cameras.add(camera("camera-" + (i + 1), (double) i / count));
    }
  }

  /** The cameras. */
  public List<CameraSpec> cameras() {
    return Collections.unmodifiableList(cameras);
  }

  /** Says that walls of any height hide everybody from all cameras; empty if one sees somebody. */
  public Optional<String> blind() {
    boolean sees =
        cameras.stream().anyMatch(camera -> !seenFrom(new Point(camera.x(), camera.y())).isEmpty());
    return cameras.isEmpty() || sees
        ? Optional.empty()
        : Optional.of("walls hide everybody from the draft cameras: move these before a run");
  }

  private CameraSpec camera(String name, double share) {
    Point border = freePoint(share);
    Point place = towardsPeople(border);
    boolean moved = place.x() != border.x() || place.y() != border.y(); // equals starts slowly
    Point target = moved ? mean(seenFrom(place)) : middle();
    CameraSpec camera =
        DraftOptics.camera(name, DraftOptics.DOME, place.x(), place.y(), target.x(), target.y());
    double far = 2 * Math.hypot(target.x() - place.x(), target.y() - place.y());
    return flat ? camera : DraftOptics.hung(camera, far);
  }

  /**
   * The point itself if it sees half as many positions as the best one on the way to the middle.
   */
  private Point towardsPeople(Point border) {
    Point middle = middle();
    Point best = border;
    int most = seenFrom(border).size();
    int enough = 2 * most;
    for (int i = 1; i < RINGS && most < way.points().size(); i++) {
      double part = (double) i / RINGS;
      Point point =
          PlanPoints.rounded(
              border.x() + part * (middle.x() - border.x()),
              border.y() + part * (middle.y() - border.y()));
      int seen = isFree(point) ? seenFrom(point).size() : 0;
      if (seen > most) {
        most = seen;
        best = point;
      }
    }
    return most > enough ? best : border;
  }

  private List<Point> seenFrom(Point camera) {
    return way.points().stream()
        .filter(point -> obstacles.clear(camera.x(), camera.y(), point.x(), point.y()))
        .toList();
  }

  private static Point mean(List<Point> points) {
    return new Point(
        points.stream().mapToDouble(Point::x).average().orElseThrow(),
        points.stream().mapToDouble(Point::y).average().orElseThrow());
  }

  private Point middle() {
    return new Point((field.minX() + field.maxX()) / 2, (field.minY() + field.maxY()) / 2);
  }

  private boolean isFree(Point point) {
    return obstacles.containing(point.x(), point.y()).isEmpty();
  }

  private Point freePoint(double share) {
    Point point = onBorder(share);
    for (int i = 1; i < TRIES && !isFree(point); i++) {
      point = onBorder((share + (double) i / TRIES) % 1);
    }
    return point;
  }

  /** A point near the border; a share of 0 is the lower left corner, then to the right. */
  private Point onBorder(double share) {
    double inset = INSET * Math.min(field.width(), field.height());
    double width = field.width() - 2 * inset;
    double height = field.height() - 2 * inset;
    double along = share * 2 * (width + height);
    double x = along < width ? along : along < width + height ? width : 2 * width + height - along;
    double y = along < width ? 0 : along < width + height ? along - width : height;
    if (along > 2 * width + height) {
      x = 0;
      y = 2 * (width + height) - along;
    }
    return PlanPoints.rounded(field.minX() + inset + x, field.minY() + inset + y);
  }
}
