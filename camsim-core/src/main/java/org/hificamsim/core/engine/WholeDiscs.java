package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.space.PointGrid;
import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.world.Cameras;

/**
 * Views that see a whole disc around the camera, and loops for them without branches, which would
 * be guessed wrong half of the time: a target is seen where a difference is negative, and the sign
 * bit of the difference says that.
 */
final class WholeDiscs {
  private final Cameras cameras;
  private final ViewRows rows;
  private double[] outside = {};
  private boolean all = true;

  WholeDiscs(Cameras cameras, ViewRows rows) {
    this.cameras = cameras;
    this.rows = rows;
  }

  /**
   * Says what a row of views sees.
   *
   * @param newOutside the smallest squared distance that is out of sight, square metres; NaN where
   *     that is no disc
   */
  void set(int row, double newOutside) {
    if (row >= outside.length) {
      outside = Arrays.copyOf(outside, Math.max(row + 1, 2 * outside.length));
    }
    outside[row] = newOutside;
    all &= newOutside > 0;
  }

  /** Whether the views of a row see a disc. */
  boolean has(int row) {
    return outside[row] > 0;
  }

  /** Whether all views do. */
  boolean isAll() {
    return all;
  }

  /** As {@link Sight#look}, for a row that has a disc. */
  int look(int camera, int row, PointGrid grid, int from, int to, int[] counts) {
    Pose pose = cameras.pose(camera);
    double below = outside[row];
    int seen = 0;
    for (int i = from; i < to; i++) {
      int hit = negative(pose.squaredDistance(grid.x(i), grid.y(i)) - below);
      counts[i] += hit;
      seen += hit;
    }
    return seen;
  }

  /** As {@link Sight#find}, for a row that has a disc. */
  int find(int camera, int row, PointGrid grid, int from, int to, long[] found, int count) {
    Pose pose = cameras.pose(camera);
    double below = outside[row];
    long first = (long) camera << Integer.SIZE;
    int filled = count;
    for (int i = from; i < to; i++) {
      found[filled] = first + i;
      filled += negative(pose.squaredDistance(grid.x(i), grid.y(i)) - below);
    }
    return filled;
  }

  /** As {@link Sight#lookAll}, where all views see discs; one method, so that it is one loop. */
  void lookAll(int from, int to, PointGrid grid, int[] detected, int[] counts) {
    for (int camera = from; camera < to; camera++) {
      double below = outside(camera);
      double x = cameras.x(camera);
      double y = cameras.y(camera);
      int seen = 0;
      for (int i = 0; i < grid.count(); i++) {
        double dx = grid.x(i) - x;
        double dy = grid.y(i) - y;
        int hit = negative(dx * dx + dy * dy - below);
        counts[i] += hit;
        seen += hit;
      }
      detected[camera] = seen;
    }
  }

  /** As {@link Sight#findAll}, where all views see discs. */
  int findAll(PointGrid grid, long[] found) {
    int filled = 0;
    for (int camera = 0; camera < cameras.count(); camera++) {
      double below = outside(camera);
      double x = cameras.x(camera);
      double y = cameras.y(camera);
      long first = (long) camera << Integer.SIZE;
      for (int i = 0; i < grid.count(); i++) {
        double dx = grid.x(i) - x;
        double dy = grid.y(i) - y;
        found[filled] = first + i;
        filled += negative(dx * dx + dy * dy - below);
      }
    }
    return filled;
  }

  /** As {@link Sight#mark}, where all views see discs. */
  void mark(int camera, int views, PointGrid grid, int from, int to, long[] masks, int words) {
    double x = cameras.x(camera);
    double y = cameras.y(camera);
    for (int i = from; i < to; i++) {
      double dx = grid.x(i) - x;
      double dy = grid.y(i) - y;
      double squared = dx * dx + dy * dy;
      int target = grid.point(i);
      for (int view = 0; view < views; view++) {
        long hit = negative(squared - outside[rows.row(camera, view)]);
        masks[view * words + (target >> 6)] |= hit << target;
      }
    }
  }

  /** Of the view that a camera sees through; 0, which all is outside of, where it sees nothing. */
  private double outside(int camera) {
    int view = cameras.seeing(camera);
    boolean sees = cameras.online(camera) && view != Cameras.NO_VIEW;
    return sees ? outside[rows.row(camera, view)] : 0;
  }

  /** 1 or 0, by the sign bit. */
  private static int negative(double difference) {
    return (int) (Double.doubleToRawLongBits(difference) >>> 63);
  }
}
