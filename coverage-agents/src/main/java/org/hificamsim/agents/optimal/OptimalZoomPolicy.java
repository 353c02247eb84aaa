package org.hificamsim.agents.optimal;

import java.util.SplittableRandom;
import java.util.function.BiFunction;
import org.hificamsim.agents.search.BoundSolver;
import org.hificamsim.agents.search.CoverageProblem;
import org.hificamsim.agents.search.Solver;
import org.hificamsim.agents.search.StepSolver;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.registry.Options;

/**
 * The configuration with the best score of all, k_min (Eq 7.1) unless the network has another
 * objective, found exactly at each step: the upper bound that thesis 7.4.1 calls greedy, computed
 * there by trying all Z^C configurations.
 *
 * <p>A camera with a view proven to detect all that its others detect stays at that view, the
 * narrowest such; where all cameras have one, there is nothing to search. Otherwise views that
 * another one dominates are left out, and among configurations of the remaining views with the best
 * score it is the one in which camera 0 detects most targets, then at its narrowest view, then
 * camera 1, and so on.
 *
 * <p>As {@code bound} it does not search: it takes a good configuration, and what it says that the
 * score could have been at most is a bound on the optimum, in a small part of the time.
 */
public final class OptimalZoomPolicy extends AbstractExactZoomPolicy {
  private final String name;
  private final BiFunction<Objective, CoverageProblem, Solver> solver;
  private DetectionSets sets;
  private int revision;
  private boolean settled;
  private boolean prepared;

  /** Reads the option {@code nodes}. */
  public OptimalZoomPolicy(Options options) {
    this(nodes(options, DEFAULT_NODES));
  }

  /**
   * @param nodes search nodes after which a step's proof is given up, 0 or more
   */
  OptimalZoomPolicy(int nodes) {
    this("optimal", (objective, problem) -> new StepSolver(objective, problem, nodes));
  }

  private OptimalZoomPolicy(String name, BiFunction<Objective, CoverageProblem, Solver> solver) {
    this.name = name;
    this.solver = solver;
  }

  /** The policy that bounds the optimum. */
  public static OptimalZoomPolicy bound() {
    return new OptimalZoomPolicy("bound", BoundSolver::new);
  }

  @Override
  public String name() {
    return name;
  }

  /** A bound on what is possible: its cameras need no time for a move. */
  @Override
  public boolean jumps() {
    return true;
  }

  @Override
  public void begin(OracleView network, SplittableRandom random) {
    sets = new DetectionSets(network, true);
    findCandidates(network);
  }

  @Override
  public void decide(OracleView network, int[] views) {
    if (network.revision() != revision) {
      findCandidates(network);
    }
    if (!settled) {
      if (!prepared) {
        prepared = true;
        search(sets, solver.apply(network.objective(), sets.problem()));
      }
      super.decide(network, views);
    } else if (anyPresent(network)) {
      settle(network, views);
    }
  }

  private void findCandidates(OracleView network) {
    revision = network.revision();
    settled = true;
    for (int camera = 0; camera < network.cameras(); camera++) {
      sets.clear(camera);
      for (int view = 0; view < network.views(camera); view++) {
        sets.add(camera, view);
      }
      sets.removeDominated(network, camera);
      settled &= sets.candidates(camera) == 1 || !network.online(camera);
    }
  }

  private void settle(OracleView network, int[] views) {
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (network.online(camera)) {
        views[camera] = sets.candidate(camera, 0);
      }
    }
  }

  private static boolean anyPresent(OracleView network) {
    for (int target = 0; target < network.targets(); target++) {
      if (network.present(target)) {
        return true;
      }
    }
    return false;
  }
}
