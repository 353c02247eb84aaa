package org.hificamsim.agents.search;

/**
 * What a search tries next: for the unsatisfied target with the least slack, the set that holds it
 * and whose camera would lose most weight ({@link Weights}) by doing without it.
 */
final class Branching {
  private static final int NONE = -1;

  private final CoverageProblem problem;
  private final Remaining remaining;
  private final Supply supply;
  private final Weights weights;

  Branching(CoverageProblem problem, Domains domains) {
    this.problem = problem;
    remaining = domains.remaining();
    supply = domains.supply();
    weights = domains.weights();
  }

  /** The next set to try; -1 when every target of the component is satisfied. */
  int next(Components components, int component) {
    int target = tightest(components, component);
    return target == NONE ? NONE : mostDecisive(target);
  }

  private int tightest(Components components, int component) {
    int tightest = NONE;
    for (int target = 0; target < problem.targets(); target++) {
      if (components.of(target) == component
          && supply.lack(target) > 0
          && (tightest == NONE || tighter(target, tightest))) {
        tightest = target;
      }
    }
    return tightest;
  }

  private boolean tighter(int target, int than) {
    int difference = supply.slack(target) - supply.slack(than);
    return difference < 0 || (difference == 0 && supply.lack(target) > supply.lack(than));
  }

  private int mostDecisive(int target) {
    int chosen = NONE;
    long most = Long.MIN_VALUE;
    for (int i = 0; i < remaining.openCameras(); i++) {
      int camera = remaining.openCamera(i);
      if (supply.undecidedOn(camera, target)) {
        int with = leastLoss(camera, target, true);
        int without = leastLoss(camera, target, false);
        long gain = weights.loss(without) - weights.loss(with);
        if (gain > most) {
          most = gain;
          chosen = with;
        }
      }
    }
    return chosen;
  }

  /** The camera's remaining set of least loss among those that hold the target, or do not. */
  private int leastLoss(int camera, int target, boolean holding) {
    int least = NONE;
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      if (remaining.has(set)
          && problem.contains(set, target) == holding
          && (least == NONE || weights.loss(set) < weights.loss(least))) {
        least = set;
      }
    }
    return least;
  }
}
