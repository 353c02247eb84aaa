package org.hificamsim.solver.cover;

import java.util.Arrays;
import java.util.Comparator;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import org.hificamsim.solver.PriceSearch;

/**
 * Bounds the score of any plan by Lagrangian relaxation. Covering a point has a price of its own,
 * its multiplier, so that candidates no longer depend on each other (Beasley, EJOR 31(1), 1987, for
 * set cover; in the same way for a budget, which has a multiplier, too). The bound holds for any
 * multipliers; subgradient steps improve it.
 *
 * <p>The multipliers of a greedy plan are the unit worth of points that still need to be covered,
 * and 0 for all others. With them, this is the data-dependent bound of submodular maximisation: the
 * worth of the plan plus the best further gains.
 */
public final class LagrangianBound implements PriceSearch.Relaxation {
  private static final PriceSearch.Pace PACE = new PriceSearch.Pace(1, 10, 0.5, 1, true);
  private static final double MIN_PACE = 1e-4;
  private static final double EPSILON = 1e-12;
  private static final int BISECTIONS = 60;

  private final CoverInstance instance;
  private final Goal goal;
  private final double scoreStep;

  /**
   * The multipliers by point. After a change, {@link #multiplierSums} and {@link #worthOfPrice} are
   * computed again.
   */
  private final double[] multipliers;

  /** The multipliers that prove the bound. */
  private final double[] bestMultipliers;

  /** The sum of the multipliers of the points of each candidate. */
  private final double[] multiplierSums;

  /** The worth of a price of 1, for the present multipliers: the multiplier of the budget. */
  private double worthOfPrice = 1;

  private final PriceSearch priceSearch = new PriceSearch(this, PACE);

  /** The score of the best plan so far. */
  private double score;

  /**
   * @param multipliers the first multipliers, by point
   */
  LagrangianBound(CoverInstance instance, Goal goal, double[] multipliers) {
    this.instance = instance;
    this.goal = goal;
    this.scoreStep = goal.scoreStep(instance);
    this.multiplierSums = new double[instance.candidates()];
    this.multipliers = multipliers.clone();
    this.bestMultipliers = multipliers.clone();
    priceSearch.begin();
  }

  /**
   * Returns the bound that a first plan gives.
   *
   * @param counts for each point, the number of times that the plan covers it
   */
  static LagrangianBound of(CoverInstance instance, Goal goal, int[] counts) {
    double[] multipliers =
        goal.isFullCover() ? cheapestShares(instance) : openUnitWorths(instance, counts);
    return new LagrangianBound(instance, goal, multipliers);
  }

  /**
   * Returns by point the least price per point of a candidate that covers it; 0 if the point needs
   * no cover.
   */
  private static double[] cheapestShares(CoverInstance instance) {
    double[] shares = new double[instance.points()];
    Arrays.fill(shares, Double.POSITIVE_INFINITY);
    for (int candidate = 0; candidate < instance.candidates(); candidate++) {
      double share = instance.prices()[candidate] / instance.covered()[candidate].length;
      for (int point : instance.covered()[candidate]) {
        shares[point] = Math.min(shares[point], share);
      }
    }
    for (int point = 0; point < shares.length; point++) {
      shares[point] = instance.needs()[point] == 0 ? 0 : shares[point];
    }
    return shares;
  }

  /** Returns by point the worth of covering it once more than a plan does. */
  private static double[] openUnitWorths(CoverInstance instance, int[] counts) {
    double[] worths = new double[instance.points()];
    for (int point = 0; point < worths.length; point++) {
      boolean open = counts[point] < instance.needs()[point];
      worths[point] = open ? instance.unitWorths()[point] : 0;
    }
    return worths;
  }

  /** The worth that no plan exceeds; for full cover, the price below which there is no plan. */
  double bound() {
    return goal.tightened(untightenedBound(), scoreStep);
  }

  private double untightenedBound() {
    return goal.isFullCover() ? -priceSearch.lowest() : priceSearch.lowest();
  }

  /** The multipliers that prove the bound, by point. */
  double[] bestMultipliers() {
    return bestMultipliers.clone();
  }

  /**
   * Returns the candidates that a better plan may contain, and those of the best plan so far, in
   * ascending order.
   */
  int[] openCandidates(double score, int[] plan) {
    double value = restoreBest();
    return IntStream.range(0, multiplierSums.length)
        .filter(
            candidate -> {
              double loss = Math.max(0, -surplus(candidate));
              double boundWith = goal.isFullCover() ? value + loss : value - loss;
              return !goal.isBest(score, goal.tightened(boundWith, scoreStep))
                  || Arrays.binarySearch(plan, candidate) >= 0;
            })
        .toArray();
  }

  /** The sum of the multipliers of a candidate's points minus the worth of its price. */
  private double surplus(int candidate) {
    return multiplierSums[candidate] - worthOfPrice * instance.prices()[candidate];
  }

  /** Returns the candidates with the lowest reduced prices and those of a plan, ascending. */
  int[] cheapestCandidates(int count, int[] plan) {
    restoreBest();
    IntStream cheapest =
        IntStream.range(0, multiplierSums.length)
            .boxed()
            .sorted(Comparator.comparingDouble(this::reducedPrice))
            .limit(count)
            .mapToInt(Integer::intValue);
    return IntStream.concat(cheapest, Arrays.stream(plan)).distinct().sorted().toArray();
  }

  /**
   * Computes the bound that multipliers prove.
   *
   * @param multipliers the multipliers by point, 0 or more
   */
  public static double value(CoverInstance instance, Goal goal, double[] multipliers) {
    double[] sums = new double[instance.candidates()];
    addUp(instance, multipliers, sums);
    double value = value(instance, goal, multipliers, sums, worthOfPrice(instance, goal, sums));
    return goal.tightened(value, goal.scoreStep(instance));
  }

  /** Updates all sums after a change of multipliers, and returns the bound that these prove. */
  private double updatedValue() {
    addUp(instance, multipliers, multiplierSums);
    worthOfPrice = worthOfPrice(instance, goal, multiplierSums);
    return value(instance, goal, multipliers, multiplierSums, worthOfPrice);
  }

  private static void addUp(CoverInstance instance, double[] multipliers, double[] sums) {
    for (int candidate = 0; candidate < sums.length; candidate++) {
      sums[candidate] = 0;
      for (int point : instance.covered()[candidate]) {
        sums[candidate] += multipliers[point];
      }
    }
  }

  private static double value(
      CoverInstance instance,
      Goal goal,
      double[] multipliers,
      double[] multiplierSums,
      double worthOfPrice) {
    double value = 0;
    for (int point = 0; point < multipliers.length; point++) {
      double rest = Math.max(0, instance.unitWorths()[point] - multipliers[point]);
      value += instance.needs()[point] * (goal.isFullCover() ? multipliers[point] : rest);
    }
    double surpluses = 0;
    for (int candidate = 0; candidate < multiplierSums.length; candidate++) {
      double price = worthOfPrice * instance.prices()[candidate];
      surpluses += Math.max(0, multiplierSums[candidate] - price);
    }
    return goal.isFullCover()
        ? value - surpluses
        : value + surpluses + worthOfPrice * goal.budget();
  }

  /**
   * The worth of a price of 1 at which the candidates that are worth their price use the budget.
   */
  private static double worthOfPrice(CoverInstance instance, Goal goal, double[] multiplierSums) {
    if (goal.isFullCover()) {
      return 1;
    }
    double low = 0;
    double high = 0;
    for (int candidate = 0; candidate < multiplierSums.length; candidate++) {
      high = Math.max(high, multiplierSums[candidate] / instance.prices()[candidate]);
    }
    for (int i = 0; i < BISECTIONS && high - low > EPSILON * high; i++) {
      double middle = (low + high) / 2;
      double spent = 0;
      for (int candidate = 0; candidate < multiplierSums.length; candidate++) {
        double price = instance.prices()[candidate];
        spent += multiplierSums[candidate] > middle * price ? price : 0;
      }
      if (spent > goal.budget()) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return high;
  }

  /**
   * Improves the bound by subgradient steps (Held, Wolfe and Crowder 1974).
   *
   * @param bestScore the score of the best plan so far
   */
  void improve(int steps, double bestScore, BooleanSupplier stop) {
    score = bestScore;
    for (int i = 0; i < steps && !isDone() && !stop.getAsBoolean(); i++) {
      priceSearch.step();
    }
  }

  @Override
  public boolean isDone() {
    return proves(score);
  }

  /** Returns the bound that the multipliers prove; for full cover, its negative. */
  @Override
  public double solveParts() {
    double value = updatedValue();
    return goal.isFullCover() ? -value : value;
  }

  @Override
  public void keepPrices() {
    System.arraycopy(multipliers, 0, bestMultipliers, 0, bestMultipliers.length);
  }

  @Override
  public void restorePrices() {
    restoreBest();
  }

  @Override
  public void changePrices() {
    move(relaxedCoverage(), Math.abs(untightenedBound() - score));
  }

  /** Whether the bound proves that no plan has a better score. */
  boolean proves(double score) {
    return goal.isBest(score, bound());
  }

  /**
   * Returns by point the number of times that the best solution of the relaxed problem covers it.
   * Candidates that are worth exactly their price share the rest of the budget.
   */
  private double[] relaxedCoverage() {
    double[] coverage = new double[instance.points()];
    double tiedPrice = 0;
    double budgetLeft = goal.budget();
    for (int candidate = 0; candidate < multiplierSums.length; candidate++) {
      if (surplus(candidate) > tieMargin(candidate)) {
        add(coverage, candidate, 1);
        budgetLeft -= instance.prices()[candidate];
      } else if (surplus(candidate) >= -tieMargin(candidate) && !goal.isFullCover()) {
        tiedPrice += instance.prices()[candidate];
      }
    }
    double share = tiedPrice > 0 ? Math.max(0, Math.min(1, budgetLeft / tiedPrice)) : 0;
    for (int candidate = 0; candidate < multiplierSums.length && share > 0; candidate++) {
      if (Math.abs(surplus(candidate)) <= tieMargin(candidate)) {
        add(coverage, candidate, share);
      }
    }
    return coverage;
  }

  private double tieMargin(int candidate) {
    return 1e-9 * worthOfPrice * instance.prices()[candidate];
  }

  /** Restores the best multipliers, and returns the bound that they prove. */
  private double restoreBest() {
    System.arraycopy(bestMultipliers, 0, multipliers, 0, bestMultipliers.length);
    return updatedValue();
  }

  private void add(double[] coverage, int candidate, double share) {
    for (int point : instance.covered()[candidate]) {
      coverage[point] += share;
    }
  }

  /**
   * Raises the multipliers of points that are covered too seldom, and lowers those of points that
   * are covered too often, within their range.
   *
   * @param gap the gap between bound and score, to which the step is proportional
   */
  private void move(double[] coverage, double gap) {
    double[] gradient = new double[coverage.length];
    double squaredNorm = 0;
    for (int point = 0; point < gradient.length; point++) {
      int needed = instance.needs()[point];
      gradient[point] = needed == 0 ? 0 : needed - coverage[point];
      boolean leavesRange =
          (gradient[point] < 0 && multipliers[point] == 0)
              || (gradient[point] > 0 && multipliers[point] == maxMultiplier(point));
      gradient[point] = leavesRange ? 0 : gradient[point];
      squaredNorm += gradient[point] * gradient[point];
    }
    double length = squaredNorm == 0 ? 0 : priceSearch.pace() * Math.max(gap, 1e-3) / squaredNorm;
    for (int point = 0; point < gradient.length; point++) {
      double moved = multipliers[point] + length * gradient[point];
      multipliers[point] = Math.max(0, Math.min(maxMultiplier(point), moved));
    }
  }

  private double maxMultiplier(int point) {
    return goal.isFullCover() ? Double.MAX_VALUE : instance.unitWorths()[point];
  }

  /** Whether the steps have become too small to matter. */
  boolean isExhausted() {
    return priceSearch.pace() < MIN_PACE;
  }

  /** The price of a candidate minus its worth for the present multipliers. */
  double reducedPrice(int candidate) {
    return instance.prices()[candidate]
        - multiplierSums[candidate] / Math.max(worthOfPrice, EPSILON);
  }
}
