package org.hificamsim.tracks.place;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.DraftOptics;
import org.hificamsim.core.scenario.spec.Field;

/**
 * A first draft of cameras: domes at equal distances along the border of the field, from its lower
 * left corner, that look at its middle. If walls have heights, cameras hang at 3 m and look down. A
 * camera that would be in a wall is moved along the border.
 */
public final class DraftCameras {
  /** The distance from the border, as a share of the field's shorter side. */
  private static final double INSET = 0.01;

  private static final int TRIES = 400;

  private DraftCameras() {}

  /** Returns {@code count} cameras. */
  public static List<CameraSpec> of(int count, Field field, Obstacles obstacles) {
    List<CameraSpec> cameras = new ArrayList<>();
    boolean flat = obstacles.all().stream().allMatch(Obstacle::full);
    for (int i = 0; i < count; i++) {
      Point place = freePoint((double) i / count, field, obstacles);
      CameraSpec camera = camera("camera-" + (i + 1), place, field);
      cameras.add(flat ? camera : DraftOptics.hung(camera, lineOfSight(place, field)));
    }
    return cameras;
  }

  /** The length of the line from a place on the border through the middle to the border, metres. */
  private static double lineOfSight(Point place, Field field) {
    double middleX = (field.minX() + field.maxX()) / 2;
    double middleY = (field.minY() + field.maxY()) / 2;
    return 2 * Math.hypot(middleX - place.x(), middleY - place.y());
  }

  private static Point freePoint(double share, Field field, Obstacles obstacles) {
    Point point = onBorder(share, field);
    for (int i = 1; i < TRIES && obstacles.containing(point.x(), point.y()).isPresent(); i++) {
      point = onBorder((share + (double) i / TRIES) % 1, field);
    }
    return point;
  }

  /** A point near the border; a share of 0 is the lower left corner, then to the right. */
  private static Point onBorder(double share, Field field) {
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
    return WallCollector.rounded(field.minX() + inset + x, field.minY() + inset + y);
  }

  private static CameraSpec camera(String name, Point place, Field field) {
    double middleX = (field.minX() + field.maxX()) / 2;
    double middleY = (field.minY() + field.maxY()) / 2;
    return DraftOptics.camera(name, DraftOptics.DOME, place.x(), place.y(), middleX, middleY);
  }
}
