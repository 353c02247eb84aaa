package org.hificamsim.agents.search;

/**
 * Branch and bound over the cameras for a choice of greater value, while the values of earlier
 * {@link ValueBounds}s stay at their goals: the open camera with the fewest sets that may lead to
 * the goal comes first, and its sets by what they gain.
 */
final class ValueSearch {
  private static final int NONE = -1;

  private final CoverageProblem problem;
  private final Decisions decisions;
  private final ValueBounds[] bounds;
  private final long[] goals;
  private final boolean[] tried;
  private Choice best;
  private int stage;
  private boolean improve;
  private boolean found;
  private long nodes;

  /**
   * @param goals of each of the bounds; those before the stage under way are kept
   */
  ValueSearch(CoverageProblem problem, Decisions decisions, ValueBounds[] bounds, long[] goals) {
    this.problem = problem;
    this.decisions = decisions;
    this.bounds = bounds;
    this.goals = goals;
    tried = new boolean[problem.maxSets()];
  }

  /** Counts nodes from 0 again. */
  void reset() {
    nodes = 0;
  }

  /** The number of nodes visited. */
  long nodes() {
    return nodes;
  }

  /**
   * Looks for the best choice by the stage's value that is better than its goal.
   *
   * @param choice receives each better one that is found; the goal of the stage rises with it
   * @return whether the choice is proven to be the best
   */
  boolean improve(int ofStage, long maxNodes, Choice choice) {
    stage = ofStage;
    improve = true;
    goals[stage] += bounds[stage].worth().step();
    boolean complete = search(maxNodes, choice);
    goals[stage] -= bounds[stage].worth().step();
    return complete;
  }

  /** Looks for any choice that reaches all goals up to a stage's; returns whether it found one. */
  boolean reach(int ofStage, long maxNodes, Choice choice) {
    stage = ofStage;
    improve = false;
    search(maxNodes, choice);
    return found;
  }

  /** Returns whether all was searched; the decisions are as they were then. */
  private boolean search(long maxNodes, Choice choice) {
    long lastNode = maxNodes > Long.MAX_VALUE - nodes ? Long.MAX_VALUE : nodes + maxNodes;
    int floor = decisions.open();
    best = choice;
    found = false;
    int camera = enter();
    while (improve || !found) {
      int set = camera == NONE ? NONE : next(camera);
      if (set != NONE) {
        if (nodes++ >= lastNode) {
          break;
        }
        tried[set] = true;
        decisions.decide(camera, set);
        camera = enter();
      } else if (decisions.open() == floor) {
        return true;
      } else {
        camera = decisions.undo();
      }
    }
    while (decisions.open() < floor) {
      decisions.undo();
    }
    return false;
  }

  /**
   * Judges the decisions; returns the camera to decide next, none where there is nothing to gain.
   */
  private int enter() {
    boolean sure = true;
    for (int i = 0; i <= stage; i++) {
      if (bounds[i].look() < goals[i]) {
        return NONE;
      }
      sure &= bounds[i].sure() >= goals[i];
    }
    if (sure) {
      keep();
    }
    return bounds[stage].bound() < goals[stage] || (found && !improve) ? NONE : branch();
  }

  /** Takes the decisions, and for open cameras what gains most beside them. */
  private void keep() {
    int floor = decisions.open();
    ValueBounds stageBounds = bounds[stage];
    while (decisions.open() > 0) {
      int camera = decisions.openCamera(0);
      decisions.decide(camera, mostGain(camera));
      stageBounds.lookAtTargets();
    }
    for (int camera = 0; camera < problem.cameras(); camera++) {
      best.exchange(camera, decisions.chosen(camera));
    }
    found = true;
    if (improve) {
      goals[stage] = stageBounds.sure() + stageBounds.worth().step();
    }
    while (decisions.open() < floor) {
      decisions.undo();
    }
    stageBounds.look();
  }

  private int mostGain(int camera) {
    int chosen = problem.firstSet(camera);
    for (int set = chosen + 1; set < problem.endSet(camera); set++) {
      chosen = bounds[stage].gain(set) > bounds[stage].gain(chosen) ? set : chosen;
    }
    return chosen;
  }

  private int branch() {
    ValueBounds stageBounds = bounds[stage];
    int chosen = NONE;
    int fewest = Integer.MAX_VALUE;
    for (int i = 0; i < decisions.open(); i++) {
      int camera = decisions.openCamera(i);
      int count = stageBounds.mostOf(camera) == 0 && stage == 0 ? Integer.MAX_VALUE : open(camera);
      if (count < fewest || (count == fewest && chosen != NONE && before(camera, chosen))) {
        fewest = count;
        chosen = camera;
      }
    }
    return fewest == 0 ? NONE : chosen;
  }

  private boolean before(int camera, int other) {
    long difference = bounds[stage].mostOf(camera) - bounds[stage].mostOf(other);
    return difference > 0 || (difference == 0 && camera < other);
  }

  /** Readies a camera's sets to be tried; returns how many may lead to the goal. */
  private int open(int camera) {
    ValueBounds stageBounds = bounds[stage];
    int count = 0;
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      tried[set] = false;
      count += decisions.isLesser(set) || !stageBounds.allows(camera, set, goals[stage]) ? 0 : 1;
    }
    return count;
  }

  /** The camera's set that gains most of those not tried that may lead to the goals. */
  private int next(int camera) {
    for (int i = 0; i <= stage; i++) {
      bounds[i].lookAtTargets();
    }
    int next = NONE;
    long most = -1;
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      if (!tried[set] && !decisions.isLesser(set) && bounds[stage].gain(set) > most) {
        if (promises(camera, set)) {
          most = bounds[stage].gain(set);
          next = set;
        }
      }
    }
    return next;
  }

  private boolean promises(int camera, int set) {
    for (int i = 0; i <= stage; i++) {
      if (!bounds[i].allows(camera, set, goals[i])) {
        return false;
      }
    }
    for (int other = problem.firstSet(camera); other < problem.endSet(camera); other++) {
      if (tried[other] && asGood(other, set)) {
        return false;
      }
    }
    return true;
  }

  /** Whether one set has all that a second one has of the targets that can rise. */
  private boolean asGood(int first, int second) {
    for (int word = 0; word < problem.words(); word++) {
      long more = problem.mask(second, word) & ~problem.mask(first, word);
      for (; more != 0; more &= more - 1) {
        int target = (word << 6) + Long.numberOfTrailingZeros(more);
        for (int i = 0; i <= stage; i++) {
          if (bounds[i].canRise(target)) {
            return false;
          }
        }
      }
    }
    return true;
  }
}
