package org.hificamsim.agents.optimal;

import java.util.SplittableRandom;
import org.hificamsim.core.InputException;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.ExpectationProvingZoomPolicy;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * The configuration with the best least expected coverage: where detections are by chance, the best
 * that can be done without knowing the luck that will be drawn ({@code docs/detection.md}). Found
 * exactly at each step by {@link ExpectedSearch}. By a threshold it looks for the best k_min, as
 * {@link OptimalZoomPolicy} does, but without telling what it could not prove. With no target
 * present the views stay.
 */
public final class OptimalExpectedZoomPolicy implements ExpectationProvingZoomPolicy {
  public static final String NAME = "optimal-expected";

  private static final int DEFAULT_NODES = 100_000;

  private final int nodes;
  private ExpectedSearch search;
  private long unprovenSteps;
  private double gap;

  /**
   * @param nodes search nodes after which a step's proof is given up, 0 or more
   */
  public OptimalExpectedZoomPolicy(int nodes) {
    this.nodes = nodes;
  }

  /** The policy with its option {@code nodes}. */
  public static OptimalExpectedZoomPolicy from(Options options) {
    return new OptimalExpectedZoomPolicy(NodeLimit.from(options, DEFAULT_NODES));
  }

  @Override
  public String name() {
    return NAME;
  }

  /** A bound on what is possible: its cameras need no time for a move. */
  @Override
  public boolean jumps() {
    return true;
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    requireKMin(network.objective());
    search = new ExpectedSearch(network.oracle(), nodes);
  }

  private static void requireKMin(Objective objective) {
    if (!objective.isKMin()) {
      throw new InputException(
          "objective is "
              + objective.text()
              + ", expected kmin with policy "
              + NAME
              + ", which looks for the best least expected coverage. Maybe use optimal");
    }
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    unprovenSteps += search.decide(network.oracle(), views) ? 0 : 1;
    gap += search.bound() - search.value();
  }

  @Override
  public long unprovenSteps() {
    return unprovenSteps;
  }

  @Override
  public double gap() {
    return gap;
  }
}
