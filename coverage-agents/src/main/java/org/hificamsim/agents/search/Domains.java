package org.hificamsim.agents.search;

/**
 * What each camera may still choose while a search for coverage k is under way, and what follows
 * from it; every removal can be undone.
 *
 * <p>Coverage k is out of reach when a target's supply is below k; when it equals k, each camera
 * that can cover the target must do so, and its sets without the target are removed. Coverage k is
 * also out of reach when the {@link Weights} leave no surplus; sets that would use up more than the
 * surplus are removed. Each change is followed by these consequences until nothing changes.
 */
final class Domains {
  private final CoverageProblem problem;
  private final Remaining remaining;
  private final Supply supply;
  private final Weights weights;
  private int k;

  Domains(CoverageProblem problem) {
    this.problem = problem;
    remaining = new Remaining(problem);
    supply = new Supply(problem, remaining);
    weights = new Weights(problem, remaining);
  }

  /** Every set remains, every target weighs the same, and nothing is demanded. */
  void reset() {
    k = 0;
    remaining.reset();
    supply.reset();
    weights.reset();
  }

  /** Changes the targets' weights, each 0 or more. */
  void weigh(long[] targetWeights) {
    weights.weigh(targetWeights);
  }

  /** The largest coverage that neither a supply nor the weights rule out. */
  int bound() {
    return Math.min(supply.least(), weights.bound());
  }

  /** Demands coverage k of every target and draws the consequences; false when impossible. */
  boolean require(int coverage) {
    k = coverage;
    supply.require(k);
    return supply.least() >= k && propagate();
  }

  /** Takes a set from its camera and draws the consequences; false when impossible. */
  boolean remove(int set) {
    supply.clearTight();
    return drop(set) && propagate();
  }

  /** Leaves a camera this one set and draws the consequences; false when impossible. */
  boolean choose(int set) {
    supply.clearTight();
    int camera = problem.cameraOf(set);
    for (int other = problem.firstSet(camera); other < problem.endSet(camera); other++) {
      if (other != set && remaining.has(other) && !drop(other)) {
        return false;
      }
    }
    return propagate();
  }

  /**
   * Takes from its camera this set and its other sets without any further unsatisfied target: if it
   * leads nowhere, neither do they. Then draws the consequences; false when impossible.
   */
  boolean removeWithLesser(int set) {
    supply.clearTight();
    int camera = problem.cameraOf(set);
    for (int other = problem.firstSet(camera); other < problem.endSet(camera); other++) {
      if (other != set && remaining.has(other) && isLesser(other, set) && !drop(other)) {
        return false;
      }
    }
    return drop(set) && propagate();
  }

  /** The number of removals so far: what {@link #undo} goes back to. */
  int mark() {
    return remaining.removals();
  }

  /** Takes back all removals after {@code mark}. */
  void undo(int mark) {
    while (remaining.removals() > mark) {
      int set = remaining.restore();
      if (remaining.count(problem.cameraOf(set)) > 1) {
        supply.restored(set);
        weights.restored(set);
      }
    }
  }

  Remaining remaining() {
    return remaining;
  }

  Supply supply() {
    return supply;
  }

  Weights weights() {
    return weights;
  }

  private boolean isLesser(int set, int than) {
    for (int word = 0; word < problem.words(); word++) {
      long more = problem.mask(set, word) & ~problem.mask(than, word);
      for (; more != 0; more &= more - 1) {
        if (supply.lack((word << 6) + Long.numberOfTrailingZeros(more)) > 0) {
          return false;
        }
      }
    }
    return true;
  }

  private boolean propagate() {
    boolean possible;
    do {
      possible = forceTight() && removeTooLight();
      // Removing light sets may have made further targets tight.
    } while (possible && supply.hasTight());
    return possible;
  }

  private boolean forceTight() {
    for (int target = supply.nextTight(); target >= 0; target = supply.nextTight()) {
      for (int i = 0; i < remaining.openCameras(); i++) {
        int camera = remaining.openCamera(i);
        if (supply.undecidedOn(camera, target) && !dropWithout(camera, target)) {
          return false;
        }
      }
    }
    return true;
  }

  private boolean dropWithout(int camera, int target) {
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      if (remaining.has(set) && !problem.contains(set, target) && !drop(set)) {
        return false;
      }
    }
    return true;
  }

  private boolean removeTooLight() {
    long surplus = weights.surplus(k);
    if (surplus < 0) {
      return false;
    }
    for (int i = 0; i < remaining.openCameras(); i++) {
      int camera = remaining.openCamera(i);
      if (remaining.count(camera) > 1 && !dropLighter(camera, surplus)) {
        return false;
      }
    }
    return true;
  }

  private boolean dropLighter(int camera, long surplus) {
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      if (remaining.has(set) && weights.loss(set) > surplus && !drop(set)) {
        return false;
      }
    }
    return true;
  }

  private boolean drop(int set) {
    if (remaining.remove(set) == 0) {
      return false;
    }
    weights.removed(set);
    return supply.removed(set);
  }
}
