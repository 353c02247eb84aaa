package org.hificamsim.placement.cover;

import java.util.Optional;
import java.util.function.BooleanSupplier;

/**
 * How a plan is searched for, and for how long.
 *
 * @param rounds without a better plan after which the search ends
 * @param enough ends the search, where an exact method goes on
 * @param most ends an exact method's search for a better plan among few candidates
 * @param stop ends all at the next opportunity; there is a plan whatever it says
 */
public record Effort(
    long seed,
    int rounds,
    Optional<ExactMethod> exact,
    BooleanSupplier enough,
    BooleanSupplier most,
    BooleanSupplier stop) {
  /** Search alone. */
  public static Effort of(long seed, int rounds, BooleanSupplier stop) {
    return new Effort(seed, rounds, Optional.empty(), stop, stop, stop);
  }

  boolean isEnough() {
    return stop.getAsBoolean() || (exact.isPresent() && enough.getAsBoolean());
  }
}
