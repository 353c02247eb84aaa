package org.hificamsim.agents.search;

import org.hificamsim.agents.search.FeasibilitySearch.Outcome;

/**
 * Of all choices that reach a coverage, the one that gives camera 0 its most preferred set, then
 * camera 1, and so on.
 *
 * <p>Whether a preferred set can be taken is answered by a swap, by {@link LocalSearch}, or by a
 * search; a search that has not decided after {@value #MAX_NODES} nodes counts as a no, so that
 * ties cost little.
 */
final class PreferredChoice {
  static final int MAX_NODES = 1_000;

  private static final int PASSES = 3;

  private final CoverageProblem problem;
  private final Domains domains;
  private final Remaining remaining;
  private final LocalSearch local;
  private final FeasibilitySearch search;
  private final Choice trial;

  PreferredChoice(
      CoverageProblem problem, Domains domains, LocalSearch local, FeasibilitySearch search) {
    this.problem = problem;
    this.domains = domains;
    this.local = local;
    this.search = search;
    remaining = domains.remaining();
    trial = new Choice(problem);
  }

  /** Improves a choice that reaches coverage k; nothing must have been removed. */
  void find(int k, Choice choice) {
    domains.require(k);
    for (int i = 0; i < remaining.openCameras(); i++) {
      settle(remaining.openCamera(i), k, choice);
    }
  }

  private void settle(int camera, int k, Choice choice) {
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      if (remaining.has(set)) {
        if (set == choice.of(camera) || choice.replace(camera, set, k) || take(set, k, choice)) {
          domains.choose(set);
          return;
        }
        domains.remove(set);
      }
    }
  }

  private boolean take(int set, int k, Choice choice) {
    int mark = domains.mark();
    boolean taken = false;
    if (domains.choose(set)) {
      trial.adapt(choice, remaining);
      taken = local.reach(k, PASSES, trial) || search.search(MAX_NODES, trial) == Outcome.FOUND;
    }
    domains.undo(mark);
    if (taken) {
      choice.copy(trial);
    }
    return taken;
  }
}
