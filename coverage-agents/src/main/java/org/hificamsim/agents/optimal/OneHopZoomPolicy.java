package org.hificamsim.agents.optimal;

import java.util.SplittableRandom;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.registry.Options;
import org.hificamsim.solver.configuration.StepSolver;

/**
 * Chooses in each step the configuration with the best score, by default k_min (Eq 7.1), among
 * those that the cameras reach within the step ({@link OracleView#reaches}; thesis 7.4.1:
 * "reachable from the current zoom level"), by an exact search.
 *
 * <p>If several configurations are best, the choice decides what can be reached next. The policy
 * takes the one in which camera 0 has the view that the option {@code ties} prefers, by default the
 * widest, then camera 1, and so on.
 */
public final class OneHopZoomPolicy extends AbstractExactZoomPolicy {
  /** The preference among configurations with equal scores, camera by camera. */
  enum Preference {
    MOST_TARGETS_THEN_NARROWEST,
    MOST_TARGETS_THEN_WIDEST,
    NARROWEST,
    WIDEST;

    private boolean prefersMostTargets() {
      return this == MOST_TARGETS_THEN_NARROWEST || this == MOST_TARGETS_THEN_WIDEST;
    }

    private boolean prefersWidest() {
      return this == MOST_TARGETS_THEN_WIDEST || this == WIDEST;
    }
  }

  private final Preference preference;
  private final int nodes;
  private DetectionSets sets;

  /** Reads the options {@code ties} and {@code nodes}. */
  public OneHopZoomPolicy(Options options) {
    preference =
        options.choice(
            "ties",
            Preference.WIDEST,
            "of equal score: widest, narrowest, most-targets-then-widest,"
                + " most-targets-then-narrowest");
    nodes = nodes(options, DEFAULT_NODES);
  }

  @Override
  public String name() {
    return "one-hop";
  }

  @Override
  public void begin(OracleView network, SplittableRandom random) {
    sets = new DetectionSets(network, preference.prefersMostTargets());
    solveWith(sets, new StepSolver(network.objective(), sets.problem(), nodes));
  }

  @Override
  public void decide(OracleView network, int[] views) {
    for (int camera = 0; camera < network.cameras(); camera++) {
      findCandidates(network, camera);
    }
    super.decide(network, views);
  }

  /**
   * Finds the views that a camera reaches within the step; if there are none, it continues to its
   * chosen view.
   */
  private void findCandidates(OracleView network, int camera) {
    sets.clear(camera);
    int last = network.views(camera) - 1;
    for (int i = 0; i <= last; i++) {
      int view = preference.prefersWidest() ? last - i : i;
      if (network.reaches(camera, view)) {
        sets.add(camera, view);
      }
    }
    if (sets.candidates(camera) == 0) {
      sets.add(camera, network.view(camera));
    }
  }
}
