package org.hificamsim.agents.optimal;

import java.util.SplittableRandom;
import org.hificamsim.agents.search.StepSolver;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.registry.Options;

/**
 * The configuration with the best score, k_min (Eq 7.1) by default, among those that the cameras
 * reach within the step ({@link OracleView#reaches}): thesis 7.4.1's "reachable from the current
 * zoom level", found exactly at each step.
 *
 * <p>Which of several best configurations is taken decides what can be reached next. It is the one
 * in which camera 0 is at the view that the option {@code ties} prefers, then camera 1, and so on;
 * the widest by default.
 */
public final class OneHopZoomPolicy extends AbstractExactZoomPolicy {
  /** What decides between configurations with the same score, camera by camera. */
  enum Preference {
    MOST_TARGETS_THEN_NARROWEST,
    MOST_TARGETS_THEN_WIDEST,
    NARROWEST,
    WIDEST;

    private boolean mostTargets() {
      return this == MOST_TARGETS_THEN_NARROWEST || this == MOST_TARGETS_THEN_WIDEST;
    }

    private boolean widest() {
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
    sets = new DetectionSets(network, preference.mostTargets());
    search(sets, new StepSolver(network.objective(), sets.problem(), nodes));
  }

  @Override
  public void decide(OracleView network, int[] views) {
    for (int camera = 0; camera < network.cameras(); camera++) {
      findCandidates(network, camera);
    }
    super.decide(network, views);
  }

  /** A camera that reaches no view within the step goes on to the one it has chosen. */
  private void findCandidates(OracleView network, int camera) {
    sets.clear(camera);
    int last = network.views(camera) - 1;
    for (int i = 0; i <= last; i++) {
      int view = preference.widest() ? last - i : i;
      if (network.reaches(camera, view)) {
        sets.add(camera, view);
      }
    }
    if (sets.candidates(camera) == 0) {
      sets.add(camera, network.view(camera));
    }
  }
}
