package org.hificamsim.profiling.fit;

/**
 * A positive parameter between two bounds, as a number without bounds for an optimiser that knows
 * none: {@code value = least (most / least)^(1 / (1 + exp(-t)))}.
 *
 * @param least above 0
 * @param most above {@code least}
 */
record Bounded(double least, double most) {
  private static final double FARTHEST = 12;

  /** The parameter for a number of the optimiser's. */
  double value(double free) {
    return least * StrictMath.pow(most / least, share(free));
  }

  /** Its derivative there. */
  double slope(double free) {
    double share = share(free);
    return value(free) * StrictMath.log(most / least) * share * (1 - share);
  }

  /** The optimiser's number for a parameter; one at a bound is taken a little inside. */
  double free(double value) {
    double share = StrictMath.log(value / least) / StrictMath.log(most / least);
    double odds = share / (1 - share);
    return Math.max(-FARTHEST, Math.min(FARTHEST, StrictMath.log(odds)));
  }

  private static double share(double free) {
    return 1 / (1 + StrictMath.exp(-free));
  }
}
