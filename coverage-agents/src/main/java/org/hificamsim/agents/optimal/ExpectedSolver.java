package org.hificamsim.agents.optimal;

import java.util.Arrays;
import org.hificamsim.solver.BranchAndBound;
import org.hificamsim.solver.BranchList;
import org.hificamsim.solver.Exchange;
import org.hificamsim.solver.PriceSearch;
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
final class ExpectedSolver extends Solver
    implements BranchList.Problem, Exchange.Choice, PriceSearch.Relaxation {
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

  /** The coverage by the rows with the greatest weighted sums, by target. */
  private final double[] relaxedCoverage;

  private final double[] weights;
  private final double[] bestWeights;
  private final int[] chosen;
  private final int[] best;

  /** The sum of the greatest weighted row sums of the camera and all later ones, by camera. */
  private final double[] restBounds;

  /** The rows of the camera whose number is the depth. */
  private final BranchList branches;

  private final PriceSearch priceSearch = new PriceSearch(this, PriceSearch.Pace.STEADY);
  private final BranchAndBound search = new BranchAndBound();

  /** The weighted sums of the rows of the cameras that have decided. */
  private double chosenWeight;

  /** The least coverage that the exchange has reached. */
  private double reached;

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
    relaxedCoverage = new double[rows.maxTargets()];
    weights = new double[rows.maxTargets()];
    bestWeights = new double[rows.maxTargets()];
    chosen = new int[rows.maxCameras()];
    best = new int[rows.maxCameras()];
    branches = new BranchList(this, rows.maxCameras());
    restBounds = new double[rows.maxCameras() + 1];
  }

  @Override
  public void solve() {
    value = -1;
    startAtEqualWeights();
    bound = priceSearch.search(ROUNDS);
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
    value = least(coverage);
  }

  private void startAtEqualWeights() {
    for (int i = 0; i < rows.targets(); i++) {
      weights[rows.target(i)] = 1.0 / rows.targets();
    }
  }

  /** Chooses each camera's row with the greatest weighted sum; returns the total of these sums. */
  @Override
  public double solveParts() {
    Arrays.fill(coverage, 0);
    double sum = 0;
    for (int camera = 0; camera < rows.cameras(); camera++) {
      chosen[camera] = greatestRow(camera);
      sum += rows.weightedSum(chosen[camera], weights);
      rows.add(chosen[camera], 1, coverage);
    }
    System.arraycopy(coverage, 0, relaxedCoverage, 0, coverage.length);
    return sum;
  }

  @Override
  public void keepPrices() {
    System.arraycopy(weights, 0, bestWeights, 0, weights.length);
  }

  @Override
  public void restorePrices() {
    System.arraycopy(bestWeights, 0, weights, 0, weights.length);
  }

  @Override
  public boolean isDone() {
    return priceSearch.lowest() <= value + TOLERANCE;
  }

  private int greatestRow(int camera) {
    int greatest = rows.first(camera);
    for (int row = greatest + 1; row < rows.first(camera + 1); row++) {
      boolean greater = rows.weightedSum(row, weights) > rows.weightedSum(greatest, weights);
      greatest = greater ? row : greatest;
    }
    return greatest;
  }

  /** Raises the weights of targets with little coverage. */
  @Override
  public void changePrices() {
    double rate = FIRST_RATE / Math.sqrt(1.0 + priceSearch.round());
    double least = least(relaxedCoverage);
    double sum = 0;
    for (int i = 0; i < rows.targets(); i++) {
      int target = rows.target(i);
      double difference = Math.min(relaxedCoverage[target] - least, MAX_DIFFERENCE);
      weights[target] *= StrictMath.exp(-rate * difference);
      weights[target] = Math.max(weights[target], MIN_WEIGHT);
      sum += weights[target];
    }
    for (int i = 0; i < rows.targets(); i++) {
      weights[rows.target(i)] /= sum;
    }
  }

  /** Changes one camera after the other as long as the least coverage rises. */
  @Override
  public void improvePlan() {
    reached = least(coverage);
    Exchange.improve(this, MAX_PASSES);
    keep(least(coverage));
  }

  @Override
  public int choosers() {
    return rows.cameras();
  }

  @Override
  public boolean exchange(int camera) {
    double before = reached;
    for (int row = rows.first(camera); row < rows.first(camera + 1); row++) {
      reached = row == chosen[camera] ? reached : swap(camera, row);
    }
    return reached > before;
  }

  /** Chooses another row of a camera if that is better; returns the least coverage then. */
  private double swap(int camera, int row) {
    rows.add(chosen[camera], -1, coverage);
    rows.add(row, 1, coverage);
    double changed = least(coverage);
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

  private double least(double[] byTarget) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < rows.targets(); i++) {
      least = Math.min(least, byTarget[rows.target(i)]);
    }
    return least;
  }

  private boolean search() {
    restBounds[rows.cameras()] = 0;
    for (int camera = rows.cameras() - 1; camera >= 0; camera--) {
      restBounds[camera] = restBounds[camera + 1] + rows.weightedSum(greatestRow(camera), weights);
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
      keep(least(coverage));
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
    chosenWeight += rows.weightedSum(row, weights);
  }

  @Override
  public void undo(int camera, int row) {
    rows.add(row, -1, coverage);
    chosenWeight -= rows.weightedSum(row, weights);
  }
}
