package org.hificamsim.placement.cover;

/**
 * What is asked of a plan: to see the most at a price, or to see everything for the least.
 *
 * @param budget the most that it may cost; infinite where everything is to be seen
 */
public record Goal(double budget) {
  private static final double ROUNDING = 1e-9;

  /** To see every sample as often as it counts, for the least. */
  public static final Goal ALL = new Goal(Double.POSITIVE_INFINITY);

  /** Whether everything is to be seen. */
  public boolean isAll() {
    return budget == Double.POSITIVE_INFINITY;
  }

  /** Whether a price is within the budget. */
  public boolean affords(double price) {
    return price <= budget * (1 + ROUNDING);
  }

  /** What a plan is judged by: its price where all is to be seen, else what it is worth. */
  public double score(CoverInstance instance, int[] plan) {
    return isAll() ? instance.price(plan) : instance.worth(instance.counts(plan));
  }

  /** The least difference between two scores that differ, 0 where it is not known. */
  double quantum(CoverInstance instance) {
    double[] values = isAll() ? instance.prices() : instance.units();
    double first = values.length == 0 ? 0 : values[0];
    for (double value : values) {
      first = isAll() ? (value == Math.rint(value) ? 1 : 0) : value;
      if (first != (isAll() ? 1 : values[0])) {
        return 0;
      }
    }
    return first;
  }

  /** A bound moved to the nearest score that there can be. */
  double tightened(double bound, double quantum) {
    if (quantum == 0) {
      return bound;
    }
    double steps = bound / quantum;
    double margin = ROUNDING * Math.max(1, Math.abs(steps));
    return quantum * (isAll() ? Math.ceil(steps - margin) : Math.floor(steps + margin));
  }

  /** Whether no plan within a bound is better than a score. */
  boolean closes(double bound, double score) {
    double margin = ROUNDING * Math.max(1, Math.abs(score));
    return isAll() ? bound >= score - margin : bound <= score + margin;
  }
}
