package org.hificamsim.agents.optimal;

import java.util.Arrays;
import org.hificamsim.core.policy.OracleView;

/**
 * Finds the configuration with the best least expected coverage: of one view for each camera, the
 * greatest minimum over the targets of the sum of their chances.
 *
 * <p>For any weights of the targets that add up to 1, the sum over the cameras of their best
 * weighed row bounds every configuration's minimum from above (Lagrangian relaxation).
 * Multiplicative weights (Arora, Hazan and Kale, Theory of Computing 8, 2012) make the bound tight,
 * and local search makes a good configuration; depth-first search with that bound then proves the
 * best one, to {@value #TOLERANCE}. It ends after a number of nodes, unproven, with the bound that
 * it began with.
 */
final class ExpectedSearch {
  static final double TOLERANCE = 1e-9;

  private static final int ROUNDS = 60;
  private static final double RATE = 2;
  private static final int MAX_PASSES = 20;

  private final ChanceRows rows;
  private final long maxNodes;
  private final double[] coverage;
  private final double[] weights;
  private final double[] bestWeights;
  private final int[] chosen;
  private final int[] best;
  private final int[] next;
  private final double[] rest;
  private double value;
  private double bound;

  /**
   * @param maxNodes search nodes after which a step's proof is given up
   */
  ExpectedSearch(OracleView network, long maxNodes) {
    this.maxNodes = maxNodes;
    rows = new ChanceRows(network);
    coverage = new double[network.targets()];
    weights = new double[network.targets()];
    bestWeights = new double[network.targets()];
    chosen = new int[network.cameras()];
    best = new int[network.cameras()];
    next = new int[network.cameras()];
    rest = new double[network.cameras() + 1];
  }

  /**
   * Writes the best configuration into {@code views}; leaves them when no target is present.
   *
   * @return whether it is proven to be the best
   */
  boolean decide(OracleView network, int[] views) {
    value = -1;
    bound = 0;
    if (!rows.fill(network)) {
      return true;
    }
    tuneWeights();
    boolean proven = bound <= value + TOLERANCE || search();
    measure();
    bound = proven ? value : bound;
    for (int camera = 0; camera < rows.cameras(); camera++) {
      views[rows.camera(camera)] = rows.view(best[camera]);
    }
    return proven;
  }

  /** What was added and taken away again leaves its rounding: all is added once more. */
  private void measure() {
    Arrays.fill(coverage, 0);
    for (int camera = 0; camera < rows.cameras(); camera++) {
      rows.add(best[camera], 1, coverage);
    }
    value = least();
  }

  /** The least expected coverage of the last configuration. */
  double value() {
    return Math.max(value, 0);
  }

  /** What no configuration exceeds. */
  double bound() {
    return Math.max(bound, 0);
  }

  private void tuneWeights() {
    bound = Double.POSITIVE_INFINITY;
    for (int i = 0; i < rows.targets(); i++) {
      weights[rows.target(i)] = 1.0 / rows.targets();
    }
    for (int round = 0; round < ROUNDS && bound > value + TOLERANCE; round++) {
      double reached = respond();
      if (reached < bound) {
        bound = reached;
        System.arraycopy(weights, 0, bestWeights, 0, weights.length);
      }
      reweigh(RATE / Math.sqrt(1.0 + round));
      improve();
    }
  }

  /** Each camera takes the row that weighs most; returns what all weigh together. */
  private double respond() {
    Arrays.fill(coverage, 0);
    double sum = 0;
    for (int camera = 0; camera < rows.cameras(); camera++) {
      chosen[camera] = heaviest(camera, weights);
      sum += rows.weigh(chosen[camera], weights);
      rows.add(chosen[camera], 1, coverage);
    }
    return sum;
  }

  private int heaviest(int camera, double[] by) {
    int heaviest = rows.first(camera);
    for (int row = heaviest + 1; row < rows.first(camera + 1); row++) {
      heaviest = rows.weigh(row, by) > rows.weigh(heaviest, by) ? row : heaviest;
    }
    return heaviest;
  }

  /** Targets with little coverage gain weight. */
  private void reweigh(double rate) {
    double least = least();
    double sum = 0;
    for (int i = 0; i < rows.targets(); i++) {
      int target = rows.target(i);
      weights[target] *= StrictMath.exp(-rate * Math.min(coverage[target] - least, 20));
      weights[target] = Math.max(weights[target], 1e-12);
      sum += weights[target];
    }
    for (int i = 0; i < rows.targets(); i++) {
      weights[rows.target(i)] /= sum;
    }
  }

  /** Changes one camera after the other while that helps the target that is covered least. */
  private void improve() {
    double reached = least();
    boolean better = true;
    for (int pass = 0; better && pass < MAX_PASSES; pass++) {
      better = false;
      for (int camera = 0; camera < rows.cameras(); camera++) {
        for (int row = rows.first(camera); row < rows.first(camera + 1); row++) {
          double tried = row == chosen[camera] ? reached : swap(camera, row, reached);
          better |= tried > reached;
          reached = tried;
        }
      }
    }
    keep(least());
  }

  /** Takes another row if that is better; returns what is reached then. */
  private double swap(int camera, int row, double reached) {
    rows.add(chosen[camera], -1, coverage);
    rows.add(row, 1, coverage);
    double tried = least();
    if (tried > reached + TOLERANCE) {
      chosen[camera] = row;
      return tried;
    }
    rows.add(row, -1, coverage);
    rows.add(chosen[camera], 1, coverage);
    return reached;
  }

  private void keep(double reached) {
    if (reached > value) {
      value = reached;
      System.arraycopy(chosen, 0, best, 0, rows.cameras());
    }
  }

  private double least() {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < rows.targets(); i++) {
      least = Math.min(least, coverage[rows.target(i)]);
    }
    return least;
  }

  /** Depth first over the cameras; returns whether all was searched. */
  private boolean search() {
    int all = rows.cameras();
    if (all == 0) {
      return true;
    }
    rest[all] = 0;
    for (int camera = all - 1; camera >= 0; camera--) {
      rest[camera] = rest[camera + 1] + rows.weigh(heaviest(camera, bestWeights), bestWeights);
    }
    Arrays.fill(coverage, 0);
    double weight = 0;
    int camera = 0;
    next[0] = rows.first(0);
    for (long nodes = 0; camera >= 0; nodes++) {
      if (nodes > maxNodes) {
        return false;
      }
      if (next[camera] > rows.first(camera)) { // one was tried here before
        rows.add(next[camera] - 1, -1, coverage);
        weight -= rows.weigh(next[camera] - 1, bestWeights);
      }
      if (next[camera] == rows.first(camera + 1)) {
        camera--;
        continue;
      }
      int row = next[camera]++;
      chosen[camera] = row;
      rows.add(row, 1, coverage);
      weight += rows.weigh(row, bestWeights);
      if (camera + 1 == all) {
        keep(least());
      } else if (weight + rest[camera + 1] > value + TOLERANCE) {
        camera++;
        next[camera] = rows.first(camera);
      }
    }
    return true;
  }
}
