package org.hificamsim.placement.cover;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Bounds on the worth of plans, by their price. Each is a {@link LagrangianBound} of its own whose
 * budget is the price. It begins with multipliers between those of the next dearer plan and the
 * unit worths, which are good for low prices, and is improved by subgradient steps.
 */
public final class CurveBounds {
  /** The number of steps for all bounds together, and for each. */
  private static final int STEPS = 1000;

  private static final int MAX_STEPS = 300;
  private static final int MIN_STEPS = 20;

  /** The parts of the next dearer plan's multipliers in those that a bound may begin with. */
  private static final List<Double> PARTS = List.of(0.0, 0.25, 0.5, 0.75, 1.0);

  private final CoverInstance instance;

  /** The multipliers of the next dearer plan. */
  private double[] multipliers;

  /**
   * @param multipliers by point, worths that prove a bound for the dearest plan
   */
  public CurveBounds(CoverInstance instance, double[] multipliers) {
    this.instance = instance;
    this.multipliers = multipliers;
  }

  /**
   * Returns a bound for each plan.
   *
   * @param prices of the plans, rising
   * @param worths of the plans, rising
   * @return by plan, the worth that no plan of its price exceeds, rising
   */
  public double[] bounds(double[] prices, double[] worths) {
    double[] bounds = new double[prices.length];
    double dearer = Double.POSITIVE_INFINITY;
    int steps = Math.max(MIN_STEPS, Math.min(MAX_STEPS, STEPS / Math.max(1, prices.length)));
    for (int plan = prices.length - 1; plan >= 0; plan--) {
      dearer = Math.min(dearer, bound(new Goal(prices[plan]), worths[plan], steps));
      bounds[plan] = dearer;
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
