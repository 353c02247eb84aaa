package org.hificamsim.solver.cover;

import java.util.Arrays;

/**
 * A plan, with a bound on the score of any other plan.
 *
 * @param chosen the chosen candidates, in ascending order
 * @param score the worth of the plan; for full cover, its price
 * @param bound the worth that no plan exceeds; for full cover, the price below which there is none
 * @param multiplierBound the bound that multipliers prove; {@code bound} is better if an {@link
 *     ExactMethod} improved it
 * @param seconds the time that the search took
 */
public record CoverPlan(
    int[] chosen, double score, double bound, MultiplierBound multiplierBound, double seconds) {
  /**
   * A bound with its proof.
   *
   * @param value the value of the bound
   * @param multipliers the multipliers by point from which {@link LagrangianBound#value} computes
   *     the bound for the candidates that are not {@linkplain Dominance dominated}
   */
  public record MultiplierBound(double value, double[] multipliers) {}

  /**
   * Returns the plan with other numbers for its candidates.
   *
   * @param numbers the other numbers by present number, in ascending order
   */
  public CoverPlan withNumbers(int[] numbers) {
    int[] numbered = Arrays.stream(chosen).map(candidate -> numbers[candidate]).toArray();
    return new CoverPlan(numbered, score, bound, multiplierBound, seconds);
  }

  /** Returns the plan with other candidates of the same problem, which are at least as good. */
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
