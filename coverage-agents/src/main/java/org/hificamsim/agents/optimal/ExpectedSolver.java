package org.hificamsim.agents.optimal;

import java.util.Arrays;
import org.hificamsim.solver.BranchAndBound;
import org.hificamsim.solver.BranchList;
import org.hificamsim.solver.configuration.Solver;

/**
 * Finds the configuration with the greatest least expected coverage. It chooses a row for each
 * camera so that the minimum over the targets of the sum of their chances is as large as possible.
 *
 * <p>For any weights of the targets with a sum of 1, the greatest weighted sums of all cameras'
 * rows add up to an upper bound of this minimum (Lagrangian relaxation). Multiplicative weights
 * (Arora, Hazan and Kale, Theory of Computing 8, 2012) tighten the bound, and local search finds a
 * good configuration. {@link BranchAndBound} over the cameras, with this bound, then proves the
 * best one to within {@value #TOLERANCE}.
 */
final class ExpectedSolver extends Solver implements BranchList.Problem {
  static final double TOLERANCE = 1e-9;

  private static final int ROUNDS = 60;
  private static final double FIRST_RATE = 2;
  private static final double MIN_WEIGHT = 1e-12;

  /** The limit of how far the weight of a target falls in a round. */
  private static final double MAX_DIFFERENCE = 20;

  private static final int MAX_PASSES = 20;

  private final ChanceRows rows;
  private final long maxNodes;
  private final double[] coverage;
  private final double[] weights;
  private final double[] bestWeights;
  private final int[] chosen;
  private final int[] best;

  /** The sum of the greatest weighted row sums of the camera and all later ones, by camera. */
  private final double[] restBounds;

  /** The rows of the camera whose number is the depth. */
  private final BranchList branches;

  private final BranchAndBound search = new BranchAndBound();

  /** The weighted sums of the rows of the cameras that have decided. */
  private double chosenWeight;

  private double value;
  private double bound;

  /**
   * @param rows the problem, which each call of {@link #solve} reads
   * @param maxNodes number of search nodes after which a call gives up the proof
   */
  ExpectedSolver(ChanceRows rows, long maxNodes) {
    this.rows = rows;
    this.maxNodes = maxNodes;
    coverage = new double[rows.maxTargets()];
    weights = new double[rows.maxTargets()];
    bestWeights = new double[rows.maxTargets()];
    chosen = new int[rows.maxCameras()];
    best = new int[rows.maxCameras()];
    branches = new BranchList(this, rows.maxCameras(), rows.maxRows());
    restBounds = new double[rows.maxCameras() + 1];
  }

  @Override
  public void solve() {
    value = -1;
    tuneWeights();
    proven = bound <= value + TOLERANCE || search();
    recomputeValue();
    gap = proven ? 0 : Math.max(bound, 0) - Math.max(value, 0);
  }

  @Override
  public int chosen(int camera) {
    return best[camera];
  }

  /** Adds all rows again, because rows that were added and removed leave rounding errors. */
  private void recomputeValue() {
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
      double newBound = chooseGreatestRows();
      if (newBound < bound) {
        bound = newBound;
        System.arraycopy(weights, 0, bestWeights, 0, weights.length);
      }
      updateWeights(FIRST_RATE / Math.sqrt(1.0 + round));
      improve();
    }
  }

  /** Chooses each camera's row with the greatest weighted sum; returns the total of these sums. */
  private double chooseGreatestRows() {
    Arrays.fill(coverage, 0);
    double sum = 0;
    for (int camera = 0; camera < rows.cameras(); camera++) {
      chosen[camera] = greatestRow(camera, weights);
      sum += rows.weightedSum(chosen[camera], weights);
      rows.add(chosen[camera], 1, coverage);
    }
    return sum;
  }

  private int greatestRow(int camera, double[] targetWeights) {
    int greatest = rows.first(camera);
    for (int row = greatest + 1; row < rows.first(camera + 1); row++) {
      boolean greater =
          rows.weightedSum(row, targetWeights) > rows.weightedSum(greatest, targetWeights);
      greatest = greater ? row : greatest;
    }
    return greatest;
  }

  /** Raises the weights of targets with little coverage. */
  private void updateWeights(double rate) {
    double least = least();
    double sum = 0;
    for (int i = 0; i < rows.targets(); i++) {
      int target = rows.target(i);
      double difference = Math.min(coverage[target] - least, MAX_DIFFERENCE);
      weights[target] *= StrictMath.exp(-rate * difference);
      weights[target] = Math.max(weights[target], MIN_WEIGHT);
      sum += weights[target];
    }
    for (int i = 0; i < rows.targets(); i++) {
      weights[rows.target(i)] /= sum;
    }
  }

  /** Changes one camera after the other as long as the least coverage rises. */
  private void improve() {
    double reached = least();
    boolean better = true;
    for (int pass = 0; better && pass < MAX_PASSES; pass++) {
      better = false;
      for (int camera = 0; camera < rows.cameras(); camera++) {
        for (int row = rows.first(camera); row < rows.first(camera + 1); row++) {
          double changed = row == chosen[camera] ? reached : swap(camera, row, reached);
          better |= changed > reached;
          reached = changed;
        }
      }
    }
    keep(least());
  }

  /** Chooses another row of a camera if that is better; returns the least coverage then. */
  private double swap(int camera, int row, double reached) {
    rows.add(chosen[camera], -1, coverage);
    rows.add(row, 1, coverage);
    double changed = least();
    if (changed > reached + TOLERANCE) {
      chosen[camera] = row;
      return changed;
    }
    rows.add(row, -1, coverage);
    rows.add(chosen[camera], 1, coverage);
    return reached;
  }

  private void keep(double newValue) {
    if (newValue > value) {
      value = newValue;
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
    restBounds[rows.cameras()] = 0;
    for (int camera = rows.cameras() - 1; camera >= 0; camera--) {
      restBounds[camera] =
          restBounds[camera + 1] + rows.weightedSum(greatestRow(camera, bestWeights), bestWeights);
    }
    Arrays.fill(coverage, 0);
    chosenWeight = 0;
    branches.begin();
    search.reset();
    return search.search(branches, maxNodes);
  }

  @Override
  public void list(int camera) {
    if (camera == rows.cameras()) {
      keep(least());
    } else if (camera == 0 || chosenWeight + restBounds[camera] > value + TOLERANCE) {
      for (int row = rows.first(camera); row < rows.first(camera + 1); row++) {
        branches.add(row);
      }
    }
  }

  @Override
  public void take(int camera, int row) {
    chosen[camera] = row;
    rows.add(row, 1, coverage);
    chosenWeight += rows.weightedSum(row, bestWeights);
  }

  @Override
  public void undo(int camera, int row) {
    rows.add(row, -1, coverage);
    chosenWeight -= rows.weightedSum(row, bestWeights);
  }
}
