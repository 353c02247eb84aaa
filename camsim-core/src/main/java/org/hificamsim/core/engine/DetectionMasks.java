package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.space.PointGrid;
import org.hificamsim.core.visibility.LevelSight;
import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;

/** The targets that a camera would detect in each of its views, as bits. */
final class DetectionMasks {
  private static final double UNKNOWN = -1;

  private final Sight sight;
  private final Cameras cameras;
  private final Targets targets;
  private final LevelTable levels;
  private final PointGrid grid;

  DetectionMasks(Sight sight, World world, LevelTable levels, PointGrid grid) {
    this.sight = sight;
    this.cameras = world.cameras();
    this.targets = world.targets();
    this.levels = levels;
    this.grid = grid;
  }

  /**
   * Fills in which targets the camera detects at each of its views.
   *
   * @param masks receives {@code words} words for each view, with a bit for each target
   */
  void fill(int camera, long[] masks, int words) {
    int views = cameras.views(camera);
    Arrays.fill(masks, 0, views * words, 0);
    if (grid.cells() == 1) {
      mark(camera, views, 0, grid.count(), masks, words);
      return;
    }
    double farthestReach = 0;
    for (int view = 0; view < views; view++) {
      farthestReach = Math.max(farthestReach, levels.reach(cameras.zoomNumber(camera, view)));
    }
    int left = grid.column(cameras.x(camera) - farthestReach);
    int right = grid.column(cameras.x(camera) + farthestReach);
    int top = grid.row(cameras.y(camera) + farthestReach);
    for (int row = grid.row(cameras.y(camera) - farthestReach); row <= top; row++) {
      mark(camera, views, grid.start(row, left), grid.end(row, right), masks, words);
    }
  }

  private void mark(int camera, int views, int from, int to, long[] masks, int words) {
    double below = farthestOutside(camera, views);
    for (int i = from; i < to; i++) {
      double dx = grid.x(i) - cameras.x(camera);
      double dy = grid.y(i) - cameras.y(camera);
      double squared = dx * dx + dy * dy;
      if (levels.allDetectAllInReach()) {
        markNear(camera, views, grid.point(i), squared, masks, words);
      } else if (squared < below) {
        markDetected(camera, views, grid.point(i), squared, masks, words);
      }
    }
  }

  private double farthestOutside(int camera, int views) {
    double farthest = 0;
    for (int view = 0; view < views && !levels.allDetectAllInReach(); view++) {
      farthest = Math.max(farthest, levels.squaredLimit(cameras.zoomNumber(camera, view)));
    }
    return farthest;
  }

  private void markNear(
      int camera, int views, int target, double squared, long[] masks, int words) {
    for (int view = 0; view < views; view++) {
      long hit = Sight.negative(squared - levels.squaredLimit(cameras.zoomNumber(camera, view)));
      masks[view * words + (target >> 6)] |= hit << target;
    }
  }

  /**
   * Marks the views that detect a target. The transmittance is computed once, when the first view
   * has the target.
   */
  private void markDetected(
      int camera, int views, int target, double squared, long[] masks, int words) {
    double luck = sight.luck(camera, target);
    double x = targets.x(target);
    double y = targets.y(target);
    double transmittance = UNKNOWN;
    double hidden = 0;
    for (int view = 0; view < views; view++) {
      LevelSight level = sight.level(camera, view, target);
      Pose pose = cameras.pose(camera, view);
      if (level.isInReach(squared) && level.isInAngle(pose, x, y)) {
        if (transmittance < 0) {
          transmittance = sight.obstruction().transmittance(camera, target);
          hidden = sight.obstruction().hiddenShare(camera, target);
        }
        boolean detected = level.detectsInView(pose, x, y, squared, luck, transmittance, hidden);
        long hit = detected ? 1 : 0;
        masks[view * words + (target >> 6)] |= hit << target;
      }
    }
  }
}
