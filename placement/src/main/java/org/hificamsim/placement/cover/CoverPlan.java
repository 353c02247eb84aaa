package org.hificamsim.placement.cover;

import java.util.Arrays;

/**
 * A plan, and how much better any other plan could be.
 *
 * @param chosen candidates, rising
 * @param score the worth of the plan; for full cover, its price
 * @param bound no plan has a greater worth; for full cover, a lower price
 * @param multiplierBound the bound that multipliers prove; {@code bound} is better if an {@link
 *     ExactMethod} improved it
 * @param seconds that the search took
 */
public record CoverPlan(
    int[] chosen, double score, double bound, MultiplierBound multiplierBound, double seconds) {
  /**
   * A bound with its proof.
   *
   * @param value of the bound
   * @param multipliers by point, from which {@link LagrangianBound#value} computes the bound for
   *     the candidates that are not {@linkplain Dominance dominated}
   */
  public record MultiplierBound(double value, double[] multipliers) {}

  /**
   * Returns the plan with other numbers for its candidates.
   *
   * @param numbers by present number, rising
   */
  public CoverPlan withNumbers(int[] numbers) {
    int[] numbered = Arrays.stream(chosen).map(candidate -> numbers[candidate]).toArray();
    return new CoverPlan(numbered, score, bound, multiplierBound, seconds);
  }

  /** Returns other candidates of the same problem, which are at least as good. */
  public CoverPlan replacedBy(int[] others, double otherScore) {
    return new CoverPlan(others, Math.max(score, otherScore), bound, multiplierBound, seconds);
  }

  /** Whether no plan of the same candidates is better. */
  public boolean isProven() {
    return gap() < 1e-9;
  }

  /** The difference between bound and score, as a share of the larger; 0 if the plan is proven. */
  public double gap() {
    double larger = Math.max(Math.abs(bound), Math.abs(score));
    return larger == 0 ? 0 : Math.max(0, Math.abs(bound - score)) / larger;
  }
}
