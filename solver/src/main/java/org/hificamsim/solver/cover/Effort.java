package org.hificamsim.solver.cover;

import java.util.Optional;
import java.util.function.BooleanSupplier;

/**
 * The method and the time of a search for a plan.
 *
 * @param seed the seed of the search's random choices
 * @param idleRounds the number of rounds without a better plan after which the search ends
 * @param exact the method that closes the gap after the search
 */
public record Effort(long seed, int idleRounds, Optional<ExactMethod> exact, Limits limits) {
  /**
   * The limits of the parts of the work.
   *
   * @param search whether the search has to end; a plan is found even if this is true at once
   * @param kernel whether the exact method's work on the most promising candidates has to end
   * @param exact whether the exact method has to end
   * @param all whether all work has to end
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
