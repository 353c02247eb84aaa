package org.hificamsim.agents.optimal;

import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.ProvingZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.hificamsim.solver.configuration.Solver;

/**
 * A policy that finds the best configuration of each step exactly, and counts the steps in which it
 * gave up the proof. Cameras keep their views in steps without a target.
 */
abstract class AbstractExactZoomPolicy implements ProvingZoomPolicy {
  /** The default limit: more than steps of a few hundred cameras need, and seconds of search. */
  static final int DEFAULT_NODES = 1_000_000;

  private ConfigurationSets sets;
  private Solver solver;
  private long unprovenSteps;
  private double gap;

  /** Reads the option {@code nodes}: how long the proof of a step may take. */
  static int nodes(Options options, int defaultNodes) {
    return options.integer(
        "nodes",
        defaultNodes,
        0,
        Integer.MAX_VALUE,
        "search nodes of a step before the best configuration found is taken, unproven");
  }

  /**
   * Sets the solver, before the first decision.
   *
   * @param newSets fills the solver's problem in each step
   */
  final void solveWith(ConfigurationSets newSets, Solver newSolver) {
    sets = newSets;
    solver = newSolver;
  }

  @Override
  public void decide(OracleView network, int[] views) {
    if (!sets.fill(network)) {
      return;
    }
    solver.solve();
    unprovenSteps += solver.proven() ? 0 : 1;
    gap += solver.gap();
    int online = 0;
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (network.online(camera)) {
        views[camera] = sets.viewOf(solver.chosen(online++));
      }
    }
  }

  @Override
  public final long unprovenSteps() {
    return unprovenSteps;
  }

  @Override
  public final double gap() {
    return gap;
  }
}
