package org.hificamsim.network.statistics;

import java.util.Arrays;
import java.util.function.ToDoubleBiFunction;
import org.hificamsim.core.world.Cameras;

/**
 * The overlaps of all pairs of cameras, in square metres, recomputed only for cameras that have
 * changed.
 */
public final class OverlapTable {
  private final Cameras cameras;
  private final ToDoubleBiFunction<RangeCircle, RangeCircle> overlap;

  /** The overlap by camera and later camera. */
  private final double[][] overlaps;

  private final RangeCircle[] circles;

  /** The last sum of each camera before and after its pairs were added. */
  private final double[] sumsBefore;

  private final double[] sumsAfter;
  private int revision = -1;

  /**
   * @param overlap gives the overlap of two cameras, of which the first is earlier in the list
   */
  OverlapTable(Cameras cameras, ToDoubleBiFunction<RangeCircle, RangeCircle> overlap) {
    this.cameras = cameras;
    this.overlap = overlap;
    int count = cameras.count();
    overlaps = new double[count][];
    Arrays.setAll(overlaps, camera -> new double[count - 1 - camera]);
    circles = new RangeCircle[count];
    sumsBefore = new double[count];
    sumsAfter = new double[count];
  }

  /** Returns {@code sum} plus the overlaps of a camera with each later camera that is online. */
  double addPairs(int camera, double sum) {
    refresh();
    if (sumsBefore[camera] != sum) {
      sumsBefore[camera] = sum;
      sumsAfter[camera] = added(camera, sum);
    }
    return sumsAfter[camera];
  }

  private double added(int camera, double sum) {
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
    Arrays.fill(sumsBefore, Double.NaN);
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
