package org.hificamsim.agents.optimal;

import java.util.Arrays;
import org.hificamsim.agents.search.BranchAndBound;
import org.hificamsim.agents.search.Solver;

/**
 * Finds the configuration with the best least expected coverage: of one row for each camera, the
 * greatest minimum over the targets of the sum of their chances.
 *
 * <p>For any weights of the targets that add up to 1, the sum over the cameras of their best
 * weighed row bounds every configuration's minimum from above (Lagrangian relaxation).
 * Multiplicative weights (Arora, Hazan and Kale, Theory of Computing 8, 2012) make the bound tight,
 * and local search makes a good configuration; {@link BranchAndBound} with that bound, camera by
 * camera, then proves the best one, to {@value #TOLERANCE}.
 */
final class ExpectedSolver extends Solver implements BranchAndBound.Tree {
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
  private final int[] next; // row to try, by camera
  private final double[] rest; // what this camera and those after it weigh at most
  private final BranchAndBound search = new BranchAndBound();
  private int depth;
  private double weight;
  private double value;
  private double bound;

  /**
   * @param rows what each call of {@link #solve} reads
   * @param maxNodes search nodes after which a call gives up the proof
   */
  ExpectedSolver(ChanceRows rows, long maxNodes) {
    this.rows = rows;
    this.maxNodes = maxNodes;
    coverage = new double[rows.maxTargets()];
    weights = new double[rows.maxTargets()];
    bestWeights = new double[rows.maxTargets()];
    chosen = new int[rows.maxCameras()];
    best = new int[rows.maxCameras()];
    next = new int[rows.maxCameras()];
    rest = new double[rows.maxCameras() + 1];
  }

  @Override
  public void solve() {
    value = -1;
    tuneWeights();
    proven = bound <= value + TOLERANCE || search();
    measure();
    gap = proven ? 0 : Math.max(bound, 0) - Math.max(value, 0);
  }

  @Override
  public int chosen(int camera) {
    return best[camera];
  }

  /** What was added and taken away again leaves its rounding: all is added once more. */
  private void measure() {
    Arrays.fill(coverage, 0);
    for (int camera = 0; camera < rows.cameras(); camera++) {
      rows.add(best[camera], 1, coverage);
    }
    value = least();
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

  private boolean search() {
    rest[rows.cameras()] = 0;
    for (int camera = rows.cameras() - 1; camera >= 0; camera--) {
      rest[camera] = rest[camera + 1] + rows.weigh(heaviest(camera, bestWeights), bestWeights);
    }
    Arrays.fill(coverage, 0);
    weight = 0;
    begin(0);
    search.reset();
    return search.search(this, maxNodes);
  }

  private void begin(int camera) {
    depth = camera;
    if (depth < rows.cameras()) {
      next[depth] = rows.first(depth);
    }
  }

  @Override
  public int branch() {
    if (depth == rows.cameras()) {
      keep(least());
      return NONE;
    }
    boolean arrives = depth > 0 && next[depth] == rows.first(depth);
    boolean cut = arrives && weight + rest[depth] <= value + TOLERANCE;
    return cut || next[depth] == rows.first(depth + 1) ? NONE : next[depth];
  }

  @Override
  public void take(int row) {
    chosen[depth] = row;
    rows.add(row, 1, coverage);
    weight += rows.weigh(row, bestWeights);
    begin(depth + 1);
  }

  @Override
  public void refuse(int row) {
    depth--;
    rows.add(row, -1, coverage);
    weight -= rows.weigh(row, bestWeights);
    next[depth]++;
  }
}
