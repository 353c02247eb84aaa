package org.hificamsim.placement.cover;

import java.util.Optional;
import java.util.function.BooleanSupplier;

/**
 * How a plan is searched for, and for how long.
 *
 * @param seed of the search's random choices
 * @param idleRounds number of rounds without a better plan after which the search ends
 * @param exact a method that closes the gap after the search
 */
public record Effort(long seed, int idleRounds, Optional<ExactMethod> exact, Limits limits) {
  /**
   * When each part of the work has to end.
   *
   * @param search the search; a plan is found even if this is true at once
   * @param kernel the exact method's work on the most promising candidates
   * @param exact the exact method
   * @param all everything
   */
  public record Limits(
      BooleanSupplier search, BooleanSupplier kernel, BooleanSupplier exact, BooleanSupplier all) {}

  /** Returns the effort of a search without an exact method. */
  public static Effort searchOnly(long seed, int idleRounds, BooleanSupplier stop) {
    return new Effort(seed, idleRounds, Optional.empty(), new Limits(stop, stop, stop, stop));
  }

  /** Whether the search has to end. */
  boolean searchEnds() {
    return limits.search().getAsBoolean();
  }
}
