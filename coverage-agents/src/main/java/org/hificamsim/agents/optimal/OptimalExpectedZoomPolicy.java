package org.hificamsim.agents.optimal;

import java.util.SplittableRandom;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.registry.Options;

/**
 * The configuration with the best least expected coverage: where detections are by chance, the best
 * that can be done without knowing the luck that will be drawn ({@code docs/detection.md}). Found
 * exactly at each step by {@link ExpectedSolver}. By a threshold it looks for the best k_min, as
 * {@link OptimalZoomPolicy} does, but without reporting what it could not prove.
 */
public final class OptimalExpectedZoomPolicy extends AbstractExactZoomPolicy {
  private static final int EXPECTED_NODES = 100_000;

  private final int nodes;

  /** Reads the option {@code nodes}. */
  public OptimalExpectedZoomPolicy(Options options) {
    nodes = nodes(options, EXPECTED_NODES);
  }

  @Override
  public String name() {
    return "optimal-expected";
  }

  /** A bound on what is possible: its cameras need no time for a move. */
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
    search(rows, new ExpectedSolver(rows, nodes));
  }
}
