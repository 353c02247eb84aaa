package org.hificamsim.placement.cover;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.ServiceLoader;
import java.util.function.BooleanSupplier;
import org.hificamsim.core.InputException;

/** Closes the gap between a plan and its bound, given time; found on the class path. */
public interface ExactMethod {
  /**
   * A plan no worse than the one it began with.
   *
   * @param chosen candidates
   * @param bound no plan has a better score; where everything is to be seen, costs less
   */
  record Found(int[] chosen, double bound) {}

  /**
   * Searches until the plan is proven or it is stopped.
   *
   * @param start a plan that is allowed; where everything is to be seen, it sees everything
   * @param bound what is known already
   */
  Found solve(CoverInstance instance, Goal goal, int[] start, double bound, BooleanSupplier stop);

  /**
   * The method on the class path.
   *
   * @throws InputException when there is none
   */
  static ExactMethod found() {
    return ServiceLoader.load(ExactMethod.class)
        .findFirst()
        .orElseThrow(
            () ->
                InputException.of(
                    "%s is not on the class path, expected its jars in CLASSPATH, or search",
                    setting("method", "exact")));
  }
}
