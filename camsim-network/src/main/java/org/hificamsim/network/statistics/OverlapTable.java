package org.hificamsim.network.statistics;

import java.util.Arrays;
import org.hificamsim.core.world.Cameras;

/**
 * An overlap of every pair of cameras, square metres, computed and added up again only where a
 * camera has changed.
 */
public final class OverlapTable {
  /** The overlap of two cameras as they are now, the first being earlier in the list. */
  interface Pair {
    double overlap(int first, int second);
  }

  private final Cameras cameras;
  private final Pair pair;
  private final double[][] overlaps; // by camera, with each later one
  private final Sector[] sectors;
  private final double[] before;
  private final double[] after;
  private final boolean[] added;
  private int looks = -1;

  OverlapTable(Cameras cameras, Pair pair) {
    this.cameras = cameras;
    this.pair = pair;
    int count = cameras.count();
    overlaps = new double[count][];
    Arrays.setAll(overlaps, camera -> new double[count - 1 - camera]);
    sectors = new Sector[count];
    before = new double[count];
    after = new double[count];
    added = new boolean[count];
  }

  /** The area that two fields of view share: what CamSim's overlap is taken for (quirk Q11). */
  public static OverlapTable exact(Cameras cameras) {
    return new OverlapTable(
        cameras,
        (first, second) -> SectorOverlap.of(Sector.of(cameras, first), Sector.of(cameras, second)));
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
    if (!added[camera] || before[camera] != sum) {
      before[camera] = sum;
      after[camera] = added(camera, sum);
      added[camera] = true;
    }
    return after[camera];
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
    if (looks == cameras.looks()) {
      return;
    }
    looks = cameras.looks();
    Arrays.fill(added, false);
    boolean[] changed = new boolean[sectors.length];
    for (int camera = 0; camera < sectors.length; camera++) {
      Sector now = Sector.of(cameras, camera);
      changed[camera] = !now.equals(sectors[camera]);
      sectors[camera] = now;
    }
    for (int first = 0; first < sectors.length; first++) {
      for (int second = first + 1; second < sectors.length; second++) {
        if (changed[first] || changed[second]) {
          overlaps[first][second - first - 1] = pair.overlap(first, second);
        }
      }
    }
  }
}
