package org.hificamsim.agents.optimal;

import java.util.SplittableRandom;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.registry.Options;

/**
 * Chooses in each step the configuration with the greatest least expected coverage, by the exact
 * search of {@link ExpectedSolver}. If detections depend on chance, this is the best that is
 * possible without knowing the luck that will be drawn ({@code docs/detection.md}). If they depend
 * on a threshold, it is the best k_min, as {@link OptimalZoomPolicy} finds it.
 */
public final class OptimalExpectedZoomPolicy extends AbstractExactZoomPolicy {
  private static final int DEFAULT_EXPECTED_NODES = 100_000;

  private final int nodes;

  /** Reads the option {@code nodes}. */
  public OptimalExpectedZoomPolicy(Options options) {
    nodes = nodes(options, DEFAULT_EXPECTED_NODES);
  }

  @Override
  public String name() {
    return "optimal-expected";
  }

  /** Lets cameras move at once, so that the score is a bound on what is possible. */
  @Override
  public boolean jumps() {
    return true;
  }

  @Override
  public boolean ofExpectation() {
    return true;
  }

  @Override
  public void begin(OracleView network, SplittableRandom random) {
    if (!network.objective().byLeast()) {
      throw InputException.of(
          "objective is %s, expected kmin with policy optimal-expected, which looks for"
              + " the best least expected coverage. Maybe use optimal",
          network.objective().text());
    }
    ChanceRows rows = new ChanceRows(network);
    solveWith(rows, new ExpectedSolver(rows, nodes));
  }
}
