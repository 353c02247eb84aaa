package org.hificamsim.agents.optimal;

import java.util.Arrays;
import org.hificamsim.core.policy.HindsightZoomPolicy;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.registry.Options;
import org.hificamsim.solver.configuration.CoverageProblem;
import org.hificamsim.solver.configuration.RunSolver;
import org.hificamsim.solver.configuration.Solver;

/**
 * Keeps the constant configuration with the best score, by default the performance (Eq 7.2), over
 * the run that follows: the best fixed view of each camera in hindsight.
 *
 * <p>The configuration is exact if each camera has a view that detects all that its other views
 * detect, as under any model that falls with distance on round fields of view, and if the search
 * ends within {@code nodes}. Otherwise it is the best configuration found.
 */
public final class BestFixedZoomPolicy implements HindsightZoomPolicy {
  private static final int DEFAULT_NODES = 10_000;

  private final int nodes;
  private final RunDetections run = new RunDetections();
  private int[] bestViews;
  private boolean proven;

  /** Reads the option {@code nodes}. */
  public BestFixedZoomPolicy(Options options) {
    nodes =
        options.integer(
            "nodes",
            DEFAULT_NODES,
            0,
            Integer.MAX_VALUE,
            "partial configurations to look at before the best one found is taken");
  }

  @Override
  public String name() {
    return "best-fixed";
  }

  /** Lets cameras move at once, so that the score is a bound on what is possible. */
  @Override
  public boolean jumps() {
    return true;
  }

  @Override
  public void rehearse(OracleView network) {
    run.add(network);
  }

  @Override
  public void decide(OracleView network, int[] views) {
    if (bestViews == null) {
      search();
    }
    for (int camera = 0; camera < bestViews.length; camera++) {
      if (network.online(camera)) {
        views[camera] = bestViews[camera];
      }
    }
  }

  private void search() {
    CoverageProblem problem = run.problem();
    Solver solver = new RunSolver(run.objective(), problem, run.ends(), nodes);
    solver.solve();
    proven = solver.proven();
    bestViews = new int[problem.cameras()];
    Arrays.setAll(bestViews, camera -> solver.chosen(camera) - problem.firstSet(camera));
  }

  /** Whether the configuration is proven to be the best constant one, from the first step on. */
  public boolean proven() {
    return proven;
  }
}
