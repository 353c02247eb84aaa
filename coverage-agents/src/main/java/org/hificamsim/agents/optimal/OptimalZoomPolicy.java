package org.hificamsim.agents.optimal;

import java.util.SplittableRandom;
import java.util.function.BiFunction;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.registry.Options;
import org.hificamsim.solver.configuration.BoundSolver;
import org.hificamsim.solver.configuration.CoverageProblem;
import org.hificamsim.solver.configuration.Solver;
import org.hificamsim.solver.configuration.StepSolver;

/**
 * Chooses in each step the configuration with the best score, by default k_min (Eq 7.1), by an
 * exact search. This is the upper bound that thesis 7.4.1 calls greedy, and computes by trying all
 * Z^C configurations.
 *
 * <p>A camera with a view that is proven to detect all that its other views detect stays at that
 * view, at the narrowest if there are several; if all cameras have one, nothing needs to be
 * searched. Otherwise dominated views are left out. Among the configurations with the best score,
 * the policy takes the one in which camera 0 detects most targets, then in its narrowest view, then
 * camera 1, and so on.
 *
 * <p>The policy {@code bound} does not search: it takes a good configuration, and its gap bounds
 * the optimum, in a small part of the time.
 */
public final class OptimalZoomPolicy extends AbstractExactZoomPolicy {
  private final String name;
  private final BiFunction<Objective, CoverageProblem, Solver> solverFactory;
  private DetectionSets sets;
  private int revision;

  /** Whether each online camera has one candidate left, so that nothing needs to be solved. */
  private boolean hasDominantViews;

  /** Whether there is a solver, which is made in the first step that needs one. */
  private boolean hasSolver;

  /** Reads the option {@code nodes}. */
  public OptimalZoomPolicy(Options options) {
    this(nodes(options, DEFAULT_NODES));
  }

  /**
   * @param nodes number of search nodes after which the proof of a step is given up, 0 or more
   */
  OptimalZoomPolicy(int nodes) {
    this("optimal", (objective, problem) -> new StepSolver(objective, problem, nodes));
  }

  private OptimalZoomPolicy(
      String name, BiFunction<Objective, CoverageProblem, Solver> solverFactory) {
    this.name = name;
    this.solverFactory = solverFactory;
  }

  /** Returns the policy that bounds the optimum. */
  public static OptimalZoomPolicy bound() {
    return new OptimalZoomPolicy("bound", BoundSolver::new);
  }

  @Override
  public String name() {
    return name;
  }

  /** Lets cameras move at once, so that the score is a bound on what is possible. */
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
    if (!hasDominantViews) {
      if (!hasSolver) {
        hasSolver = true;
        solveWith(sets, solverFactory.apply(network.objective(), sets.problem()));
      }
      super.decide(network, views);
    } else if (anyPresent(network)) {
      takeDominantViews(network, views);
    }
  }

  private void findCandidates(OracleView network) {
    revision = network.revision();
    hasDominantViews = true;
    for (int camera = 0; camera < network.cameras(); camera++) {
      sets.clear(camera);
      for (int view = 0; view < network.views(camera); view++) {
        sets.add(camera, view);
      }
      sets.removeDominated(network, camera);
      hasDominantViews &= sets.candidates(camera) == 1 || !network.online(camera);
    }
  }

  private void takeDominantViews(OracleView network, int[] views) {
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
