package org.hificamsim.solver.cover;

/**
 * The goal of a plan: to cover as much as possible within a budget, or to cover everything at the
 * lowest price (full cover).
 *
 * @param budget the greatest price of a plan; infinite for full cover
 */
public record Goal(double budget) {
  private static final double ROUNDING = 1e-9;

  /** The goal of covering every point as often as needed, at the lowest price. */
  public static final Goal FULL_COVER = new Goal(Double.POSITIVE_INFINITY);

  /** Whether everything has to be covered. */
  public boolean isFullCover() {
    return budget == Double.POSITIVE_INFINITY;
  }

  /** Whether a price is within the budget. */
  public boolean affords(double price) {
    return price <= budget * (1 + ROUNDING);
  }

  /** The score of a plan: its price for full cover, otherwise its worth. */
  public double score(CoverInstance instance, int[] plan) {
    return isFullCover() ? instance.price(plan) : instance.worth(instance.counts(plan));
  }

  /** The least difference between two unequal scores, or 0 if it is not known. */
  double scoreStep(CoverInstance instance) {
    return isFullCover() ? wholeNumberStep(instance.prices()) : equalStep(instance.unitWorths());
  }

  private static double wholeNumberStep(double[] values) {
    boolean allWhole = values.length > 0;
    for (double value : values) {
      allWhole &= value == Math.rint(value);
    }
    return allWhole ? 1 : 0;
  }

  private static double equalStep(double[] values) {
    for (double value : values) {
      if (value != values[0]) {
        return 0;
      }
    }
    return values.length == 0 ? 0 : values[0];
  }

  /**
   * Moves a bound to the nearest possible score within it: up for full cover, else down. It stays
   * where it is if the step is not known.
   */
  double tightened(double bound, double scoreStep) {
    if (scoreStep == 0) {
      return bound;
    }
    double steps = bound / scoreStep;
    double margin = ROUNDING * Math.max(1, Math.abs(steps));
    double whole = isFullCover() ? Math.ceil(steps - margin) : Math.floor(steps + margin);
    return scoreStep * whole + 0.0; // adding 0.0 turns -0.0 into 0.0
  }

  /** Whether no plan within a bound is better than a score. */
  boolean isBest(double score, double bound) {
    double margin = ROUNDING * Math.max(1, Math.abs(score));
    return isFullCover() ? bound >= score - margin : bound <= score + margin;
  }

  /** Whether a score is better than another one. */
  boolean isBetter(double score, double other) {
    return isFullCover() ? score < other : score > other;
  }
}
