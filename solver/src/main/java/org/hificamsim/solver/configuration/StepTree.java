package org.hificamsim.solver.configuration;

import org.hificamsim.solver.BitMatrix;
import org.hificamsim.solver.BranchAndBound;

/**
 * The tree of configurations that meet the requirements of some {@link Stage}s. A decision gives a
 * camera a set, and refusing it removes the set. Before each decision the stages remove sets that
 * cannot lead to such a configuration, until none removes any more.
 *
 * <p>The next decision is about the target with the fewest cameras to spare: of the cameras that
 * may cover it, the one with the fewest sets takes the set that gains most.
 */
final class StepTree implements BranchAndBound.Tree {
  private final CoverageProblem problem;
  private final RemainingSets remaining;
  private final Stage[] stages;

  /**
   * The {@link RemainingSets#mark} before the decision at each depth; the first is that of the
   * whole search.
   */
  private final int[] marks;

  private int depth;
  private int stageCount;
  private boolean improving;
  private boolean isDeadEnd;
  private boolean found;
  private Configuration result;

  StepTree(CoverageProblem problem, RemainingSets remaining, Stage[] stages) {
    this.problem = problem;
    this.remaining = remaining;
    this.stages = stages;
    marks = new int[problem.maxSets() + 1];
  }

  /**
   * Begins a search for ever better configurations: each one that is found raises the requirement
   * of the last stage.
   *
   * @param newStageCount the number of stages whose requirements have to be met
   * @param newResult receives each configuration found; the last one is the best
   */
  void beginImproving(int newStageCount, Configuration newResult) {
    begin(newStageCount, newResult);
    improving = true;
  }

  /** Begins a search for any one configuration, as {@link #beginImproving} does for the best. */
  void beginFinding(int newStageCount, Configuration newResult) {
    begin(newStageCount, newResult);
    improving = false;
  }

  private void begin(int newStageCount, Configuration newResult) {
    stageCount = newStageCount;
    result = newResult;
    found = false;
    isDeadEnd = false;
    depth = 0;
    marks[depth++] = remaining.mark();
    remaining.removeIncluded();
  }

  /** Ends the search and restores the sets that it removed. */
  void end() {
    remaining.undo(marks[0]);
  }

  /** Whether the last search found a configuration. */
  boolean found() {
    return found;
  }

  @Override
  public boolean isDone() {
    return found && !improving;
  }

  /**
   * Narrows until nothing changes, and only then decides. A configuration that is kept raises the
   * requirement, so that more can be removed.
   */
  @Override
  public int branch() {
    while (!isDeadEnd) {
      int before = remaining.mark();
      if (!narrow(stageCount) || !narrowByGains()) {
        return NONE;
      }
      if (isMetInAnyCase()) {
        keep();
        if (!improving) {
          return NONE;
        }
      } else if (remaining.mark() == before) {
        return mostGainingSet(cameraToDecide(scarcestTarget()));
      }
    }
    return NONE;
  }

  /**
   * Lets stages remove sets until none removes any more.
   *
   * @param narrowedStages the number of stages, from the first one on
   * @return whether all requirements are still in reach
   */
  boolean narrow(int narrowedStages) {
    int before;
    do {
      before = remaining.mark();
      for (int stage = 0; stage < narrowedStages; stage++) {
        if (!stages[stage].narrowByRange()) {
          return false;
        }
      }
    } while (remaining.mark() > before);
    return true;
  }

  private boolean narrowByGains() {
    for (int stage = 0; stage < stageCount; stage++) {
      if (!stages[stage].narrowByGains()) {
        return false;
      }
    }
    return true;
  }

  private boolean isMetInAnyCase() {
    boolean met = true;
    for (int stage = 0; stage < stageCount; stage++) {
      met &= stages[stage].isMetInAnyCase();
    }
    return met;
  }

  /**
   * Keeps the choice of remaining sets with the greatest gain, if any choice reaches what is
   * required.
   */
  private void keep() {
    result.clear();
    for (int camera = 0; camera < problem.cameras(); camera++) {
      boolean open = remaining.isOpen(camera);
      result.assign(camera, open ? mostGainingSet(camera) : remaining.first(camera));
    }
    found = true;
    if (improving) {
      last().require(last().value(result.coverage()) + last().step());
    }
  }

  private Stage last() {
    return stages[stageCount - 1];
  }

  /** Returns the target with the fewest cameras to spare, or none if no target needs a camera. */
  private int scarcestTarget() {
    int scarcest = NONE;
    int fewestSpare = Integer.MAX_VALUE;
    int mostNeeded = 0;
    for (int target = 0; target < problem.targets(); target++) {
      int undecided = remaining.maxCoverage(target) - remaining.minCoverage(target);
      int needed = undecided == 0 ? 0 : last().camerasNeeded(target);
      int spare = undecided - needed;
      if (needed > 0 && (spare < fewestSpare || (spare == fewestSpare && needed > mostNeeded))) {
        fewestSpare = spare;
        mostNeeded = needed;
        scarcest = target;
      }
    }
    return scarcest;
  }

  /**
   * Returns the open camera with the fewest sets, of equal ones the one that gains most.
   *
   * @param target the target that the camera may cover; any camera if it is {@link #NONE}
   */
  private int cameraToDecide(int target) {
    int chosen = NONE;
    int fewest = Integer.MAX_VALUE;
    for (int i = 0; i < remaining.choosingCameras(); i++) {
      int camera = remaining.choosingCamera(i);
      boolean eligible = target == NONE || remaining.isUndecided(camera, target);
      if (eligible && remaining.isOpen(camera)) {
        long gain = last().greatestGain(camera);
        int sets = gain == 0 ? Integer.MAX_VALUE : remaining.setCount(camera);
        if (chosen == NONE
            || sets < fewest
            || (sets == fewest && gain > last().greatestGain(chosen))) {
          fewest = sets;
          chosen = camera;
        }
      }
    }
    return chosen;
  }

  private int mostGainingSet(int camera) {
    int chosen = remaining.first(camera);
    for (int set = chosen + 1; set < problem.endSet(camera); set++) {
      chosen = remaining.has(set) && last().gain(set) > last().gain(chosen) ? set : chosen;
    }
    return chosen;
  }

  @Override
  public void take(int set) {
    marks[depth++] = remaining.mark();
    remaining.choose(set);
  }

  /**
   * Removes the set, and the camera's other sets that add no open target to those of the set: they
   * lead to nothing better than the set, and all that follows from it has been searched.
   */
  @Override
  public void refuse(int set) {
    remaining.undo(marks[--depth]);
    int camera = problem.cameraOf(set);
    for (int other = problem.firstSet(camera); other < problem.endSet(camera); other++) {
      if (other != set && remaining.has(other) && !addsOpenTarget(other, set)) {
        remaining.remove(other);
      }
    }
    isDeadEnd = !remaining.remove(set);
  }

  private boolean addsOpenTarget(int set, int refused) {
    for (int word = 0; word < problem.words(); word++) {
      long added = problem.mask(set, word) & ~problem.mask(refused, word);
      for (; added != 0; added &= added - 1) {
        int target = BitMatrix.firstColumn(word, added);
        for (int stage = 0; stage < stageCount; stage++) {
          if (stages[stage].isOpen(target)) {
            return true;
          }
        }
      }
    }
    return false;
  }
}
