package org.hificamsim.network.statistics;

import java.util.Arrays;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.core.world.Cameras;

/**
 * CamSim's overlap of every pair of cameras, square metres, computed again only where a camera has
 * changed.
 */
final class OverlapTable {
  /** A camera as CamSim's overlap takes it: a place, counted from the top left corner. */
  private record Disc(double x, double y, double radius) {}

  private final Cameras cameras;
  private final Field field;
  private final double[][] overlaps; // by camera, with each later one
  private final Disc[] discs;
  private int looks = -1;

  OverlapTable(Cameras cameras, Field field) {
    this.cameras = cameras;
    this.field = field;
    int count = cameras.count();
    overlaps = new double[count][];
    Arrays.setAll(overlaps, camera -> new double[count - 1 - camera]);
    discs = new Disc[count];
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
    if (looks == cameras.looks()) {
      return;
    }
    looks = cameras.looks();
    boolean[] changed = new boolean[discs.length];
    for (int camera = 0; camera < discs.length; camera++) {
      Disc now =
          new Disc(
              cameras.x(camera) - field.minX(),
              (field.minY() + cameras.y(camera)) * -1,
              cameras.range(camera));
      changed[camera] = !now.equals(discs[camera]);
      discs[camera] = now;
    }
    for (int first = 0; first < discs.length; first++) {
      for (int second = first + 1; second < discs.length; second++) {
        if (changed[first] || changed[second]) {
          overlaps[first][second - first - 1] = overlap(discs[first], discs[second]);
        }
      }
    }
  }

  private static double overlap(Disc a, Disc b) {
    return CamSimOverlap.of(a.x, a.y, a.radius, b.x, b.y, b.radius);
  }
}
