package org.hificamsim.runs.heat;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.runs.cells.FieldCells;
import org.hificamsim.runs.cells.ViewCells;
import org.hificamsim.runs.heat.HeatMap.Place;

/**
 * How cells were covered, summed over steps, and where targets were in them. Detections are
 * independent, so the chances of no and of one camera follow from those of each.
 */
final class CellSums {
  private final FieldCells cells;
  private final double[] none; // of the steps that are being added, as is one
  private final double[] one;
  private final double[] covered0;
  private final double[] covered1;
  private final double[] k;
  private final long[] visits;
  private final long[] detections;
  private final long[] uncovered;
  private long steps;

  CellSums(FieldCells cells) {
    this.cells = cells;
    none = new double[cells.count()];
    one = new double[cells.count()];
    covered0 = new double[cells.count()];
    covered1 = new double[cells.count()];
    k = new double[cells.count()];
    visits = new long[cells.count()];
    detections = new long[cells.count()];
    uncovered = new long[cells.count()];
  }

  /**
   * Adds what cameras see in steps that were alike.
   *
   * @param seen by each camera
   * @param count how many steps
   */
  void add(ViewCells.Seen[] seen, long count) {
    Arrays.fill(none, 1);
    Arrays.fill(one, 0);
    for (ViewCells.Seen camera : seen) {
      add(camera, count);
    }
    for (int cell = 0; cell < none.length; cell++) {
      covered0[cell] += count * none[cell];
      covered1[cell] += count * one[cell];
    }
    steps += count;
  }

  private void add(ViewCells.Seen camera, long count) {
    for (int i = 0; i < camera.cells().length; i++) {
      int cell = camera.cells()[i];
      double chance = camera.chances()[i];
      k[cell] += count * chance;
      one[cell] = one[cell] * (1 - chance) + none[cell] * chance;
      none[cell] *= 1 - chance;
    }
  }

  /** Adds the targets present in a step, where the cameras observed them. */
  void addVisits(NetworkView network) {
    for (int target = 0; target < network.targets(); target++) {
      if (network.present(target)) {
        addVisit(
            cells.at(network.oracle().targetX(target), network.oracle().targetY(target)),
            network.coverage(target));
      }
    }
  }

  private void addVisit(int cell, int cameras) {
    if (cell >= 0) {
      visits[cell]++;
      detections[cell] += cameras;
      uncovered[cell] += cameras == 0 ? 1 : 0;
    }
  }

  /** Of how many steps it has what cameras saw. */
  long steps() {
    return steps;
  }

  /**
   * A cell of the map.
   *
   * @param free whether targets can be seen there: no obstacle is in its middle
   */
  Place place(int cell, boolean free) {
    double steps0 = covered0[cell] / steps;
    double steps1 = covered1[cell] / steps;
    return new Place(
        free ? k[cell] / steps : Double.NaN,
        free ? steps0 : Double.NaN,
        free ? steps1 : Double.NaN,
        free ? Math.max(0, 1 - steps0 - steps1) : Double.NaN,
        visits[cell],
        (double) detections[cell] / visits[cell],
        (double) uncovered[cell] / visits[cell]);
  }
}
