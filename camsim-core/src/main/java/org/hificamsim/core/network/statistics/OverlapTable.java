package org.hificamsim.core.network.statistics;

import org.hificamsim.core.scenario.Field;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;

/** The overlap of every pair of cameras, computed again only where a camera has changed. */
final class OverlapTable {
  private final Cameras cameras;
  private final Field field;
  private final double[] overlap;
  private final double[] x;
  private final double[] y;
  private final double[] range;
  private int revision = -1;

  OverlapTable(World world) {
    cameras = world.cameras();
    field = world.scenario().field();
    int count = cameras.count();
    overlap = new double[count * count];
    x = new double[count];
    y = new double[count];
    range = new double[count];
    java.util.Arrays.fill(range, Double.NaN);
  }

  /** {@code sum} plus the overlap of a camera with each later one that is online, pair by pair. */
  double addPairs(int camera, double sum) {
    refresh();
    double total = sum;
    int row = camera * range.length;
    for (int later = camera + 1; later < range.length; later++) {
      if (cameras.online(later)) {
        total += overlap[row + later];
      }
    }
    return total;
  }

  private void refresh() {
    int now = cameras.revision();
    if (now == revision) {
      return;
    }
    revision = now;
    boolean[] changed = new boolean[range.length];
    for (int camera = 0; camera < range.length; camera++) {
      changed[camera] = take(camera);
    }
    for (int first = 0; first < range.length; first++) {
      for (int second = first + 1; second < range.length; second++) {
        if (changed[first] || changed[second]) {
          overlap[first * range.length + second] =
              CamSimOverlap.of(
                  x[first], y[first], range[first], x[second], y[second], range[second]);
        }
      }
    }
  }

  /** Takes over where a camera is and how far it sees; tells whether that is new. */
  private boolean take(int camera) {
    double newX = cameras.x(camera) - field.minX();
    double newY = (field.minY() + cameras.y(camera)) * -1;
    double newRange = cameras.zoom(camera, cameras.level(camera)).radius();
    boolean same = newX == x[camera] && newY == y[camera] && newRange == range[camera];
    x[camera] = newX;
    y[camera] = newY;
    range[camera] = newRange;
    return !same;
  }
}
