package org.hificamsim.agents.optimal;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.OracleView;

/**
 * What each online camera's views are worth in a step: rows of chances, by target. A view that is
 * nowhere better than another one of its camera is left out; of equal ones the narrowest stays.
 */
final class ChanceRows implements ConfigurationSets {
  private final int[] who;
  private final double[] chances;
  private final double[] dense;
  private final int[] present;
  private final int[] firstRow;
  private final int[] viewOf;
  private final int[] begin;
  private int[] target = new int[16];
  private double[] chance = new double[16];
  private int targets;
  private int cameras;

  ChanceRows(NetworkView network) {
    int views = 0;
    for (int camera = 0; camera < network.cameras(); camera++) {
      views += network.views(camera);
    }
    who = new int[network.targets()];
    chances = new double[network.targets()];
    dense = new double[network.targets()];
    present = new int[network.targets()];
    firstRow = new int[network.cameras() + 1];
    viewOf = new int[views];
    begin = new int[views + 1];
  }

  @Override
  public boolean fill(NetworkView view) {
    OracleView network = view.oracle();
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
    int rows = from;
    for (int view = 0; view < network.views(camera); view++) {
      int count = network.chances(camera, view, who, chances);
      append(rows, view, count);
      if (!isDominated(rows, from, rows)) {
        rows = withoutDominated(from, rows);
      }
    }
    return rows;
  }

  private void append(int row, int view, int count) {
    int end = begin[row] + count;
    if (end > target.length) {
      target = Arrays.copyOf(target, 2 * end);
      chance = Arrays.copyOf(chance, 2 * end);
    }
    System.arraycopy(who, 0, target, begin[row], count);
    System.arraycopy(chances, 0, chance, begin[row], count);
    viewOf[row] = view;
    begin[row + 1] = end;
  }

  private boolean isDominated(int row, int from, int to) {
    for (int other = from; other < to; other++) {
      if (dominates(other, row)) {
        return true;
      }
    }
    return false;
  }

  /** Takes out the rows that the one behind them dominates; returns the index behind that one. */
  private int withoutDominated(int from, int last) {
    int kept = from;
    for (int row = from; row < last; row++) {
      if (!dominates(last, row)) {
        move(row, kept++);
      }
    }
    move(last, kept);
    return kept + 1;
  }

  private void move(int row, int to) {
    int count = begin[row + 1] - begin[row];
    System.arraycopy(target, begin[row], target, begin[to], count);
    System.arraycopy(chance, begin[row], chance, begin[to], count);
    viewOf[to] = viewOf[row];
    begin[to + 1] = begin[to] + count;
  }

  private boolean dominates(int better, int worse) {
    for (int i = begin[better]; i < begin[better + 1]; i++) {
      dense[target[i]] = chance[i];
    }
    boolean dominates = true;
    for (int i = begin[worse]; i < begin[worse + 1]; i++) {
      dominates &= chance[i] <= dense[target[i]];
    }
    for (int i = begin[better]; i < begin[better + 1]; i++) {
      dense[target[i]] = 0;
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
    return viewOf[row];
  }

  /** Adds a row's chances, times a factor, to the coverage of targets. */
  void add(int row, double factor, double[] coverage) {
    for (int i = begin[row]; i < begin[row + 1]; i++) {
      coverage[target[i]] += factor * chance[i];
    }
  }

  /** The sum of a row's chances, each weighed by its target. */
  double weigh(int row, double[] weights) {
    double sum = 0;
    for (int i = begin[row]; i < begin[row + 1]; i++) {
      sum += weights[target[i]] * chance[i];
    }
    return sum;
  }
}
