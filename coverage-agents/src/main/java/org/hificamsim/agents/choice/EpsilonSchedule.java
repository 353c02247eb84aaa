package org.hificamsim.agents.choice;

import org.hificamsim.core.registry.Options;

/**
 * The probability of exploring over a camera's decisions n = 0, 1, ...: {@code max(least, start *
 * decay^n)}. The defaults keep it constant at the 0.1 of thesis 7.4.3 and 7.4.4.
 *
 * @param start probability at the first decision, [0, 1]
 * @param decay factor per decision, [0, 1]; 1 keeps the probability constant
 * @param least probability that decay does not go below, [0, 1]; without effect above {@code start}
 */
public record EpsilonSchedule(double start, double decay, double least) {
  /** The options {@code epsilon}, {@code epsilon-decay} and {@code epsilon-min}. */
  public static EpsilonSchedule from(Options options) {
    return new EpsilonSchedule(
        options.number("epsilon", 0.1, 0, 1, "probability of exploring, at first"),
        options.number("epsilon-decay", 1, 0, 1, "factor on epsilon after each decision"),
        options.number("epsilon-min", 0, 0, 1, "epsilon does not decay below this"));
  }

  /** The probability that follows {@code epsilon}. */
  public double next(double epsilon) {
    double decayed = epsilon * decay;
    return decayed < least ? Math.min(least, epsilon) : decayed;
  }
}
