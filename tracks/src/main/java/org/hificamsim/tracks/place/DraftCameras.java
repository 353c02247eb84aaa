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
 * Cameras as a first draft: domes evenly along the border of the field, from its lower left corner,
 * that look at its middle; where walls have heights they hang at 3 m, and look down. One that would
 * stand in a wall stands a little further on.
 */
public final class DraftCameras {
  private static final double INSET = 0.01; // of the field's shorter side
  private static final int TRIES = 400;

  private DraftCameras() {}

  /** This many cameras. */
  public static List<CameraSpec> of(int count, Field field, Obstacles obstacles) {
    List<CameraSpec> cameras = new ArrayList<>();
    boolean flat = obstacles.all().stream().allMatch(Obstacle::full);
    for (int i = 0; i < count; i++) {
      Point at = free((double) i / count, field, obstacles);
      CameraSpec camera = camera("camera-" + (i + 1), at, field);
      cameras.add(flat ? camera : DraftOptics.hung(camera, toFarSide(at, field)));
    }
    return cameras;
  }

  /** From a place on the border through the middle to the border, metres. */
  private static double toFarSide(Point at, Field field) {
    double middleX = (field.minX() + field.maxX()) / 2;
    double middleY = (field.minY() + field.maxY()) / 2;
    return 2 * Math.hypot(middleX - at.x(), middleY - at.y());
  }

  private static Point free(double part, Field field, Obstacles obstacles) {
    Point point = onBorder(part, field);
    for (int i = 1; i < TRIES && obstacles.containing(point.x(), point.y()).isPresent(); i++) {
      point = onBorder((part + (double) i / TRIES) % 1, field);
    }
    return point;
  }

  /** A point of the border, a little inside; 0 is the lower left corner, then to the right. */
  private static Point onBorder(double part, Field field) {
    double inset = INSET * Math.min(field.width(), field.height());
    double width = field.width() - 2 * inset;
    double height = field.height() - 2 * inset;
    double at = part * 2 * (width + height);
    double x = at < width ? at : at < width + height ? width : 2 * width + height - at;
    double y = at < width ? 0 : at < width + height ? at - width : height;
    if (at > 2 * width + height) {
      x = 0;
      y = 2 * (width + height) - at;
    }
    return WallCollector.rounded(field.minX() + inset + x, field.minY() + inset + y);
  }

  private static CameraSpec camera(String name, Point at, Field field) {
    double middleX = (field.minX() + field.maxX()) / 2;
    double middleY = (field.minY() + field.maxY()) / 2;
    return DraftOptics.camera(name, DraftOptics.DOME, at.x(), at.y(), middleX, middleY);
  }
}
