package org.hificamsim.solver.cover;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.ServiceLoader;
import java.util.function.BooleanSupplier;
import org.hificamsim.core.InputException;

/** Closes the gap between a plan and its bound, given enough time. */
public interface ExactMethod {
  /**
   * A plan that is at least as good as the one given.
   *
   * @param chosen the chosen candidates
   * @param bound the worth that no plan exceeds; for full cover, the price below which there is
   *     none
   */
  record Result(int[] chosen, double bound) {}

  /**
   * Searches until the plan is proven, or the search is stopped.
   *
   * @param start a plan within the budget; for full cover, one that covers everything
   * @param bound the bound that is known already
   */
  Result solve(CoverInstance instance, Goal goal, int[] start, double bound, BooleanSupplier stop);

  /**
   * Returns the method on the class path.
   *
   * @throws InputException if there is none
   */
  static ExactMethod onClassPath() {
    return ServiceLoader.load(ExactMethod.class)
        .findFirst()
        .orElseThrow(
            () ->
                InputException.of(
                    "%s is not on the class path, expected its jars in CLASSPATH, or search",
                    setting("method", "exact")));
  }
}
