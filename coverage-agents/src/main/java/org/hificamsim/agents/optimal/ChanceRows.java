package org.hificamsim.agents.optimal;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.hificamsim.core.policy.OracleView;

/**
 * The chances of each online camera's views to detect each target in a step: a row for each view. A
 * view that is nowhere better than another view of its camera is left out; of equal views the
 * narrowest stays.
 */
final class ChanceRows implements ConfigurationSets {
  /** A view with the targets that it may detect, reused in each step. */
  private static final class Row {
    private int view;
    private int count;
    private int[] targets = {};
    private double[] chances = {};

    private void set(int newView, int[] newTargets, double[] newChances, int newCount) {
      view = newView;
      count = newCount;
      if (count > targets.length) {
        targets = new int[2 * count];
        chances = new double[2 * count];
      }
      System.arraycopy(newTargets, 0, targets, 0, count);
      System.arraycopy(newChances, 0, chances, 0, count);
    }
  }

  /** The rows in use come first, camera by camera. */
  private final Row[] rows;

  private final int[] viewTargets;
  private final double[] viewChances;
  private final double[] chanceByTarget;
  private final int[] presentTargets;

  /** The first row of each online camera; the last entry is the number of rows. */
  private final int[] firstRow;

  private int targets;
  private int cameras;

  ChanceRows(OracleView network) {
    rows = new Row[IntStream.range(0, network.cameras()).map(network::views).sum()];
    Arrays.setAll(rows, row -> new Row());
    viewTargets = new int[network.targets()];
    viewChances = new double[network.targets()];
    chanceByTarget = new double[network.targets()];
    presentTargets = new int[network.targets()];
    firstRow = new int[network.cameras() + 1];
  }

  @Override
  public boolean fill(OracleView network) {
    findPresent(network);
    cameras = 0;
    for (int camera = 0; camera < network.cameras() && targets > 0; camera++) {
      if (network.online(camera)) {
        firstRow[cameras + 1] = addRows(network, camera, firstRow[cameras]);
        cameras++;
      }
    }
    return targets > 0;
  }

  private void findPresent(OracleView network) {
    targets = 0;
    for (int target = 0; target < network.targets(); target++) {
      if (network.present(target)) {
        presentTargets[targets++] = target;
      }
    }
  }

  /** Adds the rows of a camera at an index; returns the index after the last one. */
  private int addRows(OracleView network, int camera, int from) {
    int end = from;
    for (int view = 0; view < network.views(camera); view++) {
      int count = network.chances(camera, view, viewTargets, viewChances);
      rows[end].set(view, viewTargets, viewChances, count);
      if (!isDominated(from, end)) {
        end = removeDominated(from, end);
      }
    }
    return end;
  }

  private boolean isDominated(int from, int row) {
    boolean dominated = false;
    for (int other = from; other < row && !dominated; other++) {
      dominated = dominates(rows[other], rows[row]);
    }
    return dominated;
  }

  /** Removes the rows that the last one dominates; returns the index after the last one. */
  private int removeDominated(int from, int last) {
    int kept = from;
    for (int row = from; row <= last; row++) {
      if (row == last || !dominates(rows[last], rows[row])) {
        Row keptRow = rows[row];
        rows[row] = rows[kept];
        rows[kept++] = keptRow;
      }
    }
    return kept;
  }

  private boolean dominates(Row better, Row worse) {
    for (int i = 0; i < better.count; i++) {
      chanceByTarget[better.targets[i]] = better.chances[i];
    }
    boolean dominates = true;
    for (int i = 0; i < worse.count; i++) {
      dominates &= worse.chances[i] <= chanceByTarget[worse.targets[i]];
    }
    for (int i = 0; i < better.count; i++) {
      chanceByTarget[better.targets[i]] = 0;
    }
    return dominates;
  }

  int maxCameras() {
    return firstRow.length - 1;
  }

  int maxTargets() {
    return viewTargets.length;
  }

  /** The number of online cameras. */
  int cameras() {
    return cameras;
  }

  /** The number of targets that are present. */
  int targets() {
    return targets;
  }

  /** The i-th target that is present. */
  int target(int i) {
    return presentTargets[i];
  }

  /** The first row of an online camera; the rows of the next camera follow its last one. */
  int first(int camera) {
    return firstRow[camera];
  }

  @Override
  public int viewOf(int row) {
    return rows[row].view;
  }

  /** Adds the chances of a row, times a factor, to the coverage of targets. */
  void add(int number, double factor, double[] coverage) {
    Row row = rows[number];
    for (int i = 0; i < row.count; i++) {
      coverage[row.targets[i]] += factor * row.chances[i];
    }
  }

  /** The sum of the chances of a row, weighted by target. */
  double weightedSum(int number, double[] weights) {
    Row row = rows[number];
    double sum = 0;
    for (int i = 0; i < row.count; i++) {
      sum += weights[row.targets[i]] * row.chances[i];
    }
    return sum;
  }
}
