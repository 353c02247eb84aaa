package org.hificamsim.agents.optimal;

import java.util.Arrays;
import org.hificamsim.agents.search.CoverageProblem;
import org.hificamsim.agents.search.RunSolver;
import org.hificamsim.agents.search.Solver;
import org.hificamsim.core.policy.HindsightZoomPolicy;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.registry.Options;

/**
 * The constant configuration with the best score, the performance (Eq 7.2) by default, over the
 * very run that follows: what the best fixed zoom of each camera would have been, in hindsight.
 *
 * <p>Exact where each camera has a view that includes what its others detect, as under any model
 * that falls with distance on round fields of view, and wherever the search ends within {@code
 * nodes}; otherwise the best configuration found until then.
 */
public final class BestFixedZoomPolicy implements HindsightZoomPolicy {
  private static final int NODES = 10_000;

  private final int nodes;
  private final RunDetections run = new RunDetections();
  private int[] best;
  private boolean proven;

  /** Reads the option {@code nodes}. */
  public BestFixedZoomPolicy(Options options) {
    nodes =
        options.integer(
            "nodes",
            NODES,
            0,
            Integer.MAX_VALUE,
            "partial configurations to look at before the best one found is taken");
  }

  @Override
  public String name() {
    return "best-fixed";
  }

  /** A bound on what is possible: its cameras need no time for a move. */
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
    if (best == null) {
      search();
    }
    for (int camera = 0; camera < best.length; camera++) {
      if (network.online(camera)) {
        views[camera] = best[camera];
      }
    }
  }

  private void search() {
    CoverageProblem problem = run.problem();
    Solver solver = new RunSolver(run.objective(), problem, run.ends(), nodes);
    solver.solve();
    proven = solver.proven();
    best = new int[problem.cameras()];
    Arrays.setAll(best, camera -> solver.chosen(camera) - problem.firstSet(camera));
  }

  /** Whether the configuration is proven to be the best constant one; known from the first step. */
  public boolean proven() {
    return proven;
  }
}
