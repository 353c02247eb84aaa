package org.hificamsim.solver.cover;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Computes bounds on the worth of plans by their price. Each is a {@link LagrangianBound} of its
 * own whose budget is the price. It begins with multipliers between those of the next more
 * expensive plan and the unit worths, which are good for low prices, and is improved by subgradient
 * steps.
 */
public final class CurveBounds {
  /** The number of steps for all bounds together. */
  private static final int TOTAL_STEPS = 1000;

  /** The greatest number of steps for a bound. */
  private static final int MAX_STEPS = 300;

  /** The smallest number of steps for a bound. */
  private static final int MIN_STEPS = 20;

  /** The parts of the more expensive plan's multipliers in those that a bound may begin with. */
  private static final List<Double> PARTS = List.of(0.0, 0.25, 0.5, 0.75, 1.0);

  private final CoverInstance instance;

  /** The multipliers of the next more expensive plan. */
  private double[] multipliers;

  /**
   * @param multipliers the multipliers by point that prove a bound for the most expensive plan
   */
  public CurveBounds(CoverInstance instance, double[] multipliers) {
    this.instance = instance;
    this.multipliers = multipliers;
  }

  /**
   * Returns a bound for each plan.
   *
   * @param prices the prices of the plans, in ascending order
   * @param worths the worths of the plans, in ascending order
   * @return by plan the worth that no plan of its price exceeds, in ascending order
   */
  public double[] bounds(double[] prices, double[] worths) {
    double[] bounds = new double[prices.length];
    double nextBound = Double.POSITIVE_INFINITY;
    int steps = Math.max(MIN_STEPS, Math.min(MAX_STEPS, TOTAL_STEPS / Math.max(1, prices.length)));
    for (int plan = prices.length - 1; plan >= 0; plan--) {
      nextBound = Math.min(nextBound, bound(new Goal(prices[plan]), worths[plan], steps));
      bounds[plan] = nextBound;
    }
    return bounds;
  }

  private double bound(Goal goal, double worth, int steps) {
    LagrangianBound bound =
        PARTS.stream()
            .map(this::mixed)
            .map(start -> new LagrangianBound(instance, goal, start))
            .min(Comparator.comparingDouble(LagrangianBound::bound))
            .orElseThrow();
    bound.improve(steps, worth, () -> false);
    multipliers = bound.bestMultipliers();
    return bound.bound();
  }

  private double[] mixed(double part) {
    return IntStream.range(0, multipliers.length)
        .mapToDouble(i -> part * multipliers[i] + (1 - part) * instance.unitWorths()[i])
        .toArray();
  }
}
