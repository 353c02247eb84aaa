package org.hificamsim.network.statistics;

import java.util.Arrays;
import java.util.function.ToDoubleBiFunction;
import org.hificamsim.core.world.Cameras;

/**
 * An overlap of every pair of cameras, square metres, computed and added up again only where a
 * camera has changed.
 */
public final class OverlapTable {
  private final Cameras cameras;
  private final ToDoubleBiFunction<RangeCircle, RangeCircle> overlap;

  /** By camera, and by later camera. */
  private final double[][] overlaps;

  private final RangeCircle[] circles;
  private int revision = -1;

  /**
   * @param overlap of two cameras, the first being earlier in the list
   */
  OverlapTable(Cameras cameras, ToDoubleBiFunction<RangeCircle, RangeCircle> overlap) {
    this.cameras = cameras;
    this.overlap = overlap;
    int count = cameras.count();
    overlaps = new double[count][];
    Arrays.setAll(overlaps, camera -> new double[count - 1 - camera]);
    circles = new RangeCircle[count];
  }

  /** {@code sum} plus the overlap of a camera with each later one that is online, pair by pair. */
  double addPairs(int camera, double sum) {
    refresh();
    double total = sum;
    double[] row = overlaps[camera];
    for (int i = 0; i < row.length; i++) {
      if (cameras.online(camera + 1 + i)) {
        total += row[i];
      }
    }
    return total;
  }

  private void refresh() {
    if (revision == cameras.viewRevision()) {
      return;
    }
    revision = cameras.viewRevision();
    boolean[] changed = new boolean[circles.length];
    for (int camera = 0; camera < circles.length; camera++) {
      RangeCircle circle = RangeCircle.of(cameras, camera);
      changed[camera] = !circle.equals(circles[camera]);
      circles[camera] = circle;
    }
    for (int first = 0; first < circles.length; first++) {
      for (int second = first + 1; second < circles.length; second++) {
        if (changed[first] || changed[second]) {
          overlaps[first][second - first - 1] =
              overlap.applyAsDouble(circles[first], circles[second]);
        }
      }
    }
  }
}
