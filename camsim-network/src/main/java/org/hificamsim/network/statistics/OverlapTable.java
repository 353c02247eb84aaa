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
  private final ToDoubleBiFunction<FieldOfView, FieldOfView> overlap;
  private final double[][] overlaps; // by camera, with each later one
  private final FieldOfView[] fields;
  private int revision = -1;

  /**
   * @param overlap of two cameras, the first being earlier in the list
   */
  OverlapTable(Cameras cameras, ToDoubleBiFunction<FieldOfView, FieldOfView> overlap) {
    this.cameras = cameras;
    this.overlap = overlap;
    int count = cameras.count();
    overlaps = new double[count][];
    Arrays.setAll(overlaps, camera -> new double[count - 1 - camera]);
    fields = new FieldOfView[count];
  }

  /** The area that two fields of view share: what CamSim's overlap is taken for (quirk Q11). */
  public static OverlapTable exact(Cameras cameras) {
    return new OverlapTable(cameras, FieldOfView::overlap);
  }

  /** The sum over all pairs of cameras that are online. */
  public double sum() {
    double sum = 0;
    for (int camera = 0; camera < cameras.count(); camera++) {
      if (cameras.online(camera)) {
        sum = addPairs(camera, sum);
      }
    }
    return sum;
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
    boolean[] changed = new boolean[fields.length];
    for (int camera = 0; camera < fields.length; camera++) {
      FieldOfView now = FieldOfView.of(cameras, camera);
      changed[camera] = !now.equals(fields[camera]);
      fields[camera] = now;
    }
    for (int first = 0; first < fields.length; first++) {
      for (int second = first + 1; second < fields.length; second++) {
        if (changed[first] || changed[second]) {
          overlaps[first][second - first - 1] =
              overlap.applyAsDouble(fields[first], fields[second]);
        }
      }
    }
  }
}
