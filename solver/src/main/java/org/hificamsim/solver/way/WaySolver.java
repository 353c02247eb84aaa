package org.hificamsim.solver.way;

import java.util.Arrays;
import org.hificamsim.solver.PriceSearch;

/**
 * The most that cameras can score in a run if their moves take time: a plan, and a bound that no
 * policy exceeds.
 *
 * <p>The bound is a Lagrangian decomposition. Cameras pay a price for each set that they use in a
 * step, and earn it on their ways: the best of each step less its prices, and the most rewarding
 * way of each camera, add up to a bound at any prices. Subgradients with Polyak's step lower it.
 * Prices of 0 give the sum of the steps' optima, so that the bound never exceeds that.
 */
public final class WaySolver implements PriceSearch.Relaxation {
  private static final long STEP_NODES = 6_000;
  private static final double MEMORY = 0.7;
  private static final PriceSearch.Pace PACE = new PriceSearch.Pace(0.15, 5, 0.6, 1.1, false);
  private static final int PLAN_INTERVAL = 5;
  private static final int ORDERS = 8;
  private static final double ROUNDING = 1e-9;

  private final WayProblem problem;
  private final TurnPlanner planner;
  private final PricedStep pricedStep;
  private final MostRewardingWay search;
  private final CameraWays rewardingWays;
  private final double[] prices;
  private final double[] bestPrices;
  private final double[] direction;
  private final PriceSearch priceSearch = new PriceSearch(this, PACE);
  private double bound = Double.POSITIVE_INFINITY;

  /** Prepares the search for a plan and a bound. */
  public WaySolver(WayProblem problem) {
    this.problem = problem;
    planner = new TurnPlanner(problem);
    pricedStep = new PricedStep(problem, STEP_NODES);
    search = new MostRewardingWay(problem);
    rewardingWays = new CameraWays(problem);
    prices = new double[problem.sets()];
    bestPrices = new double[problem.sets()];
    direction = new double[problem.sets()];
  }

  /**
   * Searches until the plan is proven to be the best, or the iterations are used up.
   *
   * @param maxIterations greatest number of iterations, 0 or more
   */
  public void solve(int maxIterations) {
    for (int seed = 0; seed < ORDERS; seed++) {
      planner.planFromNothing(seed);
    }
    if (maxIterations > 0) {
      bound = priceSearch.search(maxIterations);
    }
  }

  @Override
  public double solveParts() {
    return bound(prices, direction);
  }

  @Override
  public void keepPrices() {
    System.arraycopy(prices, 0, bestPrices, 0, prices.length);
  }

  @Override
  public void restorePrices() {
    System.arraycopy(bestPrices, 0, prices, 0, prices.length);
  }

  @Override
  public void improvePlan() {
    if (priceSearch.round() % PLAN_INTERVAL == 0) {
      planner.planFrom(rewardingWays, priceSearch.round(), 1);
    }
  }

  @Override
  public boolean isDone() {
    return rounded(priceSearch.lowest()) <= score();
  }

  /** Computes the bound of given prices, so that it can be checked without a search. */
  public double boundBy(double[] setPrices) {
    return bound(setPrices, new double[setPrices.length]);
  }

  private double bound(double[] setPrices, double[] change) {
    for (int set = 0; set < change.length; set++) {
      change[set] *= MEMORY;
    }
    double sum = 0;
    for (int step = 0; step < problem.steps(); step++) {
      sum += pricedStep.solve(step, setPrices);
      for (int camera = 0; camera < problem.cameras(); camera++) {
        change[pricedStep.used(camera)] += 1;
      }
    }
    for (int camera = 0; camera < problem.cameras(); camera++) {
      sum += search.search(camera, setPrices, rewardingWays);
      for (int set : rewardingWays.seen(camera)) {
        change[set] -= 1;
      }
    }
    change[WayProblem.NOTHING] = 0;
    return sum + ROUNDING * Math.max(1, Math.abs(sum));
  }

  @Override
  public void changePrices() {
    double surplus = priceSearch.pace() * (priceSearch.value() - score());
    double norm = 0;
    for (int set = 0; set < prices.length; set++) {
      if (prices[set] > 0 || direction[set] > 0) {
        norm += direction[set] * direction[set];
      } else {
        direction[set] = 0;
      }
    }
    for (int set = 0; norm > 0 && set < prices.length; set++) {
      prices[set] = Math.max(0, prices[set] + surplus * direction[set] / norm);
    }
  }

  /** The score of the plan. */
  public double score() {
    return planner.bestScore();
  }

  /** The bound on the score of any policy whose moves take time. */
  public double bound() {
    return Math.max(rounded(bound), score());
  }

  /** Scores are whole numbers, unless they are shares. */
  private double rounded(double lowestBound) {
    return problem.objective().isShare() ? lowestBound : Math.floor(lowestBound);
  }

  /** The prices of the bound, by set. */
  public double[] prices() {
    return Arrays.copyOf(bestPrices, bestPrices.length);
  }

  /** Returns for each step the view that the plan sends a camera to. */
  public int[] goals(int camera) {
    return planner.best().goals(camera);
  }
}
