package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.policy.SeenTask;
import org.hificamsim.core.space.PointGrid;
import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.world.Cameras;

/**
 * Looks for targets where a camera can have them in sight: in the cells of the grid that its reach
 * touches, row by row. Any number of threads may ask.
 */
final class NearTargets {
  private static final int MAX_AT_ONCE = 1 << 16;

  private final Cameras cameras;
  private final Sight sight;
  private final PointGrid grid;

  NearTargets(Cameras cameras, Sight sight, PointGrid grid) {
    this.cameras = cameras;
    this.sight = sight;
    this.grid = grid;
  }

  /**
   * Counts the targets that a camera detects.
   *
   * @param view {@link Cameras#NO_VIEW} sees none
   * @param counts by index in the grid; one is added for each target that is detected
   */
  int look(int camera, int view, int[] counts) {
    if (view == Cameras.NO_VIEW) {
      return 0;
    }
    if (grid.cells() == 1) {
      return sight.look(camera, view, grid, 0, grid.count(), counts);
    }
    double reach = sight.reach(camera, view);
    int left = left(camera, reach);
    int right = right(camera, reach);
    int top = top(camera, reach);
    int seen = 0;
    for (int row = bottom(camera, reach); row <= top; row++) {
      seen += sight.look(camera, view, grid, grid.start(row, left), grid.end(row, right), counts);
    }
    return seen;
  }

  /** As {@link org.hificamsim.core.policy.OracleView#chances(int, int, int[], double[])}. */
  int chances(int camera, int view, int[] who, double[] chances) {
    double reach = sight.reach(camera, view);
    int left = left(camera, reach);
    int right = right(camera, reach);
    int top = top(camera, reach);
    int count = 0;
    for (int row = bottom(camera, reach); row <= top; row++) {
      int end = grid.end(row, right);
      for (int i = grid.start(row, left); i < end; i++) {
        chances[count] = sight.chance(camera, view, grid.point(i));
        who[count] = grid.point(i);
        count += chances[count] > 0 ? 1 : 0;
      }
    }
    return count;
  }

  /**
   * Does a task for each target that a camera detects.
   *
   * @param view {@link Cameras#NO_VIEW} sees none
   */
  <T> void eachSeen(int camera, int view, T work, SeenTask<T> task) {
    if (view == Cameras.NO_VIEW) {
      return;
    }
    double reach = sight.reach(camera, view);
    int left = left(camera, reach);
    int right = right(camera, reach);
    int top = top(camera, reach);
    for (int row = bottom(camera, reach); row <= top; row++) {
      int end = grid.end(row, right);
      for (int i = grid.start(row, left); i < end; i++) {
        if (sight.detects(camera, view, grid.point(i))) {
          see(cameras.pose(camera, view), i, work, task);
        }
      }
    }
  }

  /** As {@link org.hificamsim.core.policy.NetworkView#findSeen}. */
  void findSeen(SeenPairs pairs) {
    int all = findAll(pairs);
    int count = all < 0 ? find(pairs) : all;
    long[] found = pairs.scratch(0);
    pairs.clear();
    for (int i = 0; i < count; i++) {
      add((int) (found[i] >>> Integer.SIZE), (int) found[i], pairs);
    }
  }

  /** Finds pairs at once, where they are few enough for room for all; else -1. */
  private int findAll(SeenPairs pairs) {
    long all = (long) cameras.count() * grid.count();
    return grid.cells() == 1 && all < MAX_AT_ONCE
        ? sight.findAll(grid, pairs.scratch((int) all + 1))
        : -1;
  }

  /** Finds pairs camera by camera. */
  private int find(SeenPairs pairs) {
    int count = 0;
    for (int camera = 0; camera < cameras.count(); camera++) {
      int view = cameras.seeing(camera);
      if (view != Cameras.NO_VIEW && cameras.online(camera)) {
        count = find(camera, view, pairs.scratch(count + grid.count() + 1), count);
      }
    }
    return count;
  }

  private void add(int camera, int i, SeenPairs pairs) {
    Pose pose = cameras.pose(camera, cameras.seeing(camera));
    double dx = grid.x(i) - pose.x();
    double dy = grid.y(i) - pose.y();
    double ahead = dx * pose.headingX() + dy * pose.headingY();
    double right = dx * pose.headingY() - dy * pose.headingX();
    pairs.add(camera, grid.point(i), ahead, right);
  }

  /** Finds the targets that a camera detects, from an entry of what was found on. */
  private int find(int camera, int view, long[] found, int first) {
    if (grid.cells() == 1) {
      return sight.find(camera, view, grid, 0, grid.count(), found, first);
    }
    double reach = sight.reach(camera, view);
    int left = left(camera, reach);
    int right = right(camera, reach);
    int top = top(camera, reach);
    int count = first;
    for (int row = bottom(camera, reach); row <= top; row++) {
      int start = grid.start(row, left);
      count = sight.find(camera, view, grid, start, grid.end(row, right), found, count);
    }
    return count;
  }

  private <T> void see(Pose pose, int i, T work, SeenTask<T> task) {
    double dx = grid.x(i) - pose.x();
    double dy = grid.y(i) - pose.y();
    double bearing = Math.IEEEremainder(Math.atan2(dx, dy) - pose.heading(), 2 * Math.PI);
    task.see(work, grid.point(i), Math.hypot(dx, dy), bearing);
  }

  /** As {@link org.hificamsim.core.policy.OracleView#detections}. */
  void mark(int camera, long[] masks, int words) {
    int views = cameras.views(camera);
    Arrays.fill(masks, 0, views * words, 0);
    if (grid.cells() == 1) {
      sight.mark(camera, views, grid, 0, grid.count(), masks, words);
      return;
    }
    double reach = 0;
    for (int view = 0; view < views; view++) {
      reach = Math.max(reach, sight.reach(camera, view));
    }
    int left = left(camera, reach);
    int right = right(camera, reach);
    int top = top(camera, reach);
    for (int row = bottom(camera, reach); row <= top; row++) {
      sight.mark(camera, views, grid, grid.start(row, left), grid.end(row, right), masks, words);
    }
  }

  private int left(int camera, double reach) {
    return grid.column(cameras.x(camera) - reach);
  }

  private int right(int camera, double reach) {
    return grid.column(cameras.x(camera) + reach);
  }

  private int bottom(int camera, double reach) {
    return grid.row(cameras.y(camera) - reach);
  }

  private int top(int camera, double reach) {
    return grid.row(cameras.y(camera) + reach);
  }
}
