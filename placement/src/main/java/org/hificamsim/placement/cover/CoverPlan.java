package org.hificamsim.placement.cover;

/**
 * A plan, and how much better any other could be.
 *
 * @param chosen candidates, rising
 * @param score what it is worth; where everything is to be seen, what it costs
 * @param bound no plan has a better score; where everything is to be seen, costs less
 * @param relaxed the bound that multipliers prove; {@code bound} is better where an {@link
 *     ExactMethod} found so
 * @param proof the multipliers by sample, from which {@link Duals#value} makes {@code relaxed} for
 *     the candidates that none {@link Dominance dominates}
 * @param seconds that it took
 */
public record CoverPlan(
    int[] chosen, double score, double bound, double relaxed, double[] proof, double seconds) {
  /** Whether no plan of the same candidates is better. */
  public boolean isProven() {
    return gap() < 1e-9;
  }

  /** The difference between bound and score, as a share of the larger, 0 for a proven best. */
  public double gap() {
    double most = Math.max(Math.abs(bound), Math.abs(score));
    return most == 0 ? 0 : Math.max(0, Math.abs(bound - score)) / most;
  }
}
