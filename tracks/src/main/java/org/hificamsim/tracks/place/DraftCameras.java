package org.hificamsim.tracks.place;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.hificamsim.core.Texts;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.DraftOptics;
import org.hificamsim.core.scenario.spec.Field;

/**
 * A first draft of cameras: domes at equal distances along the border of the field, from its lower
 * left corner, that look at its middle. If walls have heights, cameras hang at 3 m and look down. A
 * camera that would be in a wall is moved along the border. A camera that sees few people, because
 * of walls or distance, is moved towards the middle, to the position where it sees most, and looks
 * at them.
 */
public final class DraftCameras {
  /** The distance from the border, as a share of the field's shorter side. */
  private static final double INSET = 0.01;

  private static final int TRIES = 400;

  /** The number of positions between the border and the middle. */
  private static final int RINGS = 40;

  /** The pixels per metre at which cameras see a person. */
  private final double pixelsPerMetre;

  private final Field field;
  private final Obstacles obstacles;
  private final PeoplePositions positions;
  private final boolean flat;
  private final List<CameraSpec> cameras = new ArrayList<>();

  /**
   * @param positions positions of people that cameras should see
   * @param count number of cameras
   * @param pixelsPerMetre pixel density that cameras need to see people
   */
  public DraftCameras(
      Field field,
      Obstacles obstacles,
      PeoplePositions positions,
      int count,
      double pixelsPerMetre) {
    this.pixelsPerMetre = pixelsPerMetre;
    this.field = field;
    this.obstacles = obstacles;
    this.positions = positions;
    this.flat = obstacles.all().stream().allMatch(Obstacle::full);
    for (int i = 0; i < count; i++) {
      cameras.add(camera("camera-" + (i + 1), (double) i / count));
    }
  }

  /** The cameras. */
  public List<CameraSpec> cameras() {
    return Collections.unmodifiableList(cameras);
  }

  /** A warning that no camera sees anybody, with the reason; empty if one does. */
  public Optional<String> blindnessWarning() {
    if (cameras.isEmpty()
        || cameras.stream()
            .anyMatch(camera -> positions.points().stream().anyMatch(sees(camera)))) {
      return Optional.empty();
    }
    boolean isClear =
        cameras.stream()
            .map(camera -> new Point(camera.x(), camera.y()))
            .anyMatch(
                position ->
                    positions.points().stream().anyMatch(point -> isClear(position, point)));
    return Optional.of(
        isClear
            ? Texts.format(
                "nobody is in view of the draft cameras, which see people up to %.0f m away: move"
                    + " these before a run",
                reach(Collections.min(DraftOptics.DOME.anglesOfView())))
            : "walls hide everybody from the draft cameras: move these before a run");
  }

  /** Whether a camera sees a position at one of its angles of view and pans. */
  private Predicate<Point> sees(CameraSpec camera) {
    return point -> {
      double dx = point.x() - camera.x();
      double dy = point.y() - camera.y();
      double bearing = Math.toDegrees(Math.atan2(dx, dy)) - camera.get(CameraSpec.HEADING);
      double offset =
          DraftOptics.DOME.pans().stream()
              .mapToDouble(pan -> Math.abs(Math.IEEEremainder(bearing - pan, 360)))
              .min()
              .orElseThrow();
      return DraftOptics.DOME.anglesOfView().stream()
              .anyMatch(angle -> 2 * offset <= angle && Math.hypot(dx, dy) <= reach(angle))
          && isClear(new Point(camera.x(), camera.y()), point);
    };
  }

  /** The distance at which a picture has the pixels per metre that are needed, in metres. */
  private double reach(double angleOfView) {
    double width = DraftOptics.DOME.pixels().orElseThrow() / pixelsPerMetre;
    return width / 2 / Math.tan(Math.toRadians(angleOfView) / 2);
  }

  private CameraSpec camera(String name, double share) {
    Point border = freePoint(share);
    Point position = towardsPeople(border);
    boolean moved =
        position.x() != border.x() || position.y() != border.y(); // equals starts slowly
    Point target = moved ? mean(seenFrom(position)) : middle();
    CameraSpec camera =
        DraftOptics.camera(
            name, DraftOptics.DOME, position.x(), position.y(), target.x(), target.y());
    double far = 2 * Math.hypot(target.x() - position.x(), target.y() - position.y());
    return flat ? camera : DraftOptics.hung(camera, far);
  }

  /**
   * Returns the border point if it sees at least half as many positions as the best point between
   * it and the middle; otherwise the best point.
   */
  private Point towardsPeople(Point border) {
    Point middle = middle();
    Point best = border;
    int most = seenFrom(border).size();
    int enough = 2 * most;
    for (int i = 1; i < RINGS && most < positions.points().size(); i++) {
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
    double reach = reach(Collections.min(DraftOptics.DOME.anglesOfView()));
    return positions.points().stream()
        .filter(point -> Math.hypot(point.x() - camera.x(), point.y() - camera.y()) <= reach)
        .filter(point -> isClear(camera, point))
        .toList();
  }

  private boolean isClear(Point camera, Point point) {
    return obstacles.clear(camera.x(), camera.y(), point.x(), point.y());
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
