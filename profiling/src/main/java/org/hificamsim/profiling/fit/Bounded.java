package org.hificamsim.profiling.fit;

/**
 * A positive parameter between two bounds, mapped to an unbounded number for the optimiser: {@code
 * value = least (most / least)^(1 / (1 + exp(-t)))}.
 *
 * @param least above 0
 * @param most above {@code least}
 */
public record Bounded(double least, double most) {
  private static final double FARTHEST = 12;

  /** Returns the parameter for a number of the optimiser. */
  public double value(double free) {
    return least * StrictMath.pow(most / least, share(free));
  }

  /** Returns the derivative of {@link #value}. */
  public double slope(double free) {
    double share = share(free);
    return value(free) * StrictMath.log(most / least) * share * (1 - share);
  }

  /** Returns the optimiser's number for a parameter, which is moved slightly inside its bounds. */
  public double free(double value) {
    double share = StrictMath.log(value / least) / StrictMath.log(most / least);
    double odds = share / (1 - share);
    return Math.max(-FARTHEST, Math.min(FARTHEST, StrictMath.log(odds)));
  }

  private static double share(double free) {
    return 1 / (1 + StrictMath.exp(-free));
  }
}
