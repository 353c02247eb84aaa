package org.hificamsim.agents.optimal;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.hificamsim.core.policy.OracleView;

/**
 * What each online camera's views are worth in a step: rows of chances, by target. A view that is
 * nowhere better than another one of its camera is left out; of equal ones the narrowest stays.
 */
final class ChanceRows implements ConfigurationSets {
  /** A view with the targets that it may detect; used again for each step. */
  private static final class Row {
    private int view;
    private int count;
    private int[] targets = {};
    private double[] chances = {};

    private void set(int newView, int[] who, double[] sure, int newCount) {
      view = newView;
      count = newCount;
      if (count > targets.length) {
        targets = new int[2 * count];
        chances = new double[2 * count];
      }
      System.arraycopy(who, 0, targets, 0, count);
      System.arraycopy(sure, 0, chances, 0, count);
    }
  }

  private final Row[] rows; // those in use first, camera by camera
  private final int[] who;
  private final double[] chances;
  private final double[] dense;
  private final int[] present;
  private final int[] firstRow;
  private int targets;
  private int cameras;

  ChanceRows(OracleView network) {
    rows = new Row[IntStream.range(0, network.cameras()).map(network::views).sum()];
    Arrays.setAll(rows, row -> new Row());
    who = new int[network.targets()];
    chances = new double[network.targets()];
    dense = new double[network.targets()];
    present = new int[network.targets()];
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
    for (int one = 0; one < network.targets(); one++) {
      if (network.present(one)) {
        present[targets++] = one;
      }
    }
  }

  /** Adds the rows of a camera from an index on; returns the index behind the last. */
  private int addRows(OracleView network, int camera, int from) {
    int end = from;
    for (int view = 0; view < network.views(camera); view++) {
      rows[end].set(view, who, chances, network.chances(camera, view, who, chances));
      if (!isDominated(from, end)) {
        end = withoutDominated(from, end);
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

  /** Takes out the rows that the one behind them dominates; returns the index behind that one. */
  private int withoutDominated(int from, int last) {
    int kept = from;
    for (int row = from; row <= last; row++) {
      if (row == last || !dominates(rows[last], rows[row])) {
        Row one = rows[row];
        rows[row] = rows[kept];
        rows[kept++] = one;
      }
    }
    return kept;
  }

  private boolean dominates(Row better, Row worse) {
    for (int i = 0; i < better.count; i++) {
      dense[better.targets[i]] = better.chances[i];
    }
    boolean dominates = true;
    for (int i = 0; i < worse.count; i++) {
      dominates &= worse.chances[i] <= dense[worse.targets[i]];
    }
    for (int i = 0; i < better.count; i++) {
      dense[better.targets[i]] = 0;
    }
    return dominates;
  }

  int maxCameras() {
    return firstRow.length - 1;
  }

  int maxTargets() {
    return who.length;
  }

  /** The number of online cameras. */
  int cameras() {
    return cameras;
  }

  /** The number of targets present. */
  int targets() {
    return targets;
  }

  /** The i-th target present. */
  int target(int i) {
    return present[i];
  }

  /** The first row of an online camera; those of the next follow its last. */
  int first(int camera) {
    return firstRow[camera];
  }

  @Override
  public int viewOf(int row) {
    return rows[row].view;
  }

  /** Adds a row's chances, times a factor, to the coverage of targets. */
  void add(int row, double factor, double[] coverage) {
    Row one = rows[row];
    for (int i = 0; i < one.count; i++) {
      coverage[one.targets[i]] += factor * one.chances[i];
    }
  }

  /** The sum of a row's chances, each weighed by its target. */
  double weigh(int row, double[] weights) {
    Row one = rows[row];
    double sum = 0;
    for (int i = 0; i < one.count; i++) {
      sum += weights[one.targets[i]] * one.chances[i];
    }
    return sum;
  }
}
