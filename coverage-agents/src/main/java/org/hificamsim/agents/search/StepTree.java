package org.hificamsim.agents.search;

/**
 * The configurations of a step that have what is required of some {@link Stage}s: a decision gives
 * a camera a set, and refusing it takes the set away. Before each decision the stages remove sets
 * that lead nowhere, until none does.
 *
 * <p>For the target that has fewest cameras to spare, the camera with the fewest sets decides, and
 * takes the set that gains most.
 */
final class StepTree implements BranchAndBound.Tree {
  private final CoverageProblem problem;
  private final RemainingSets remaining;
  private final Stage[] stages;
  private final int[] marks;
  private int depth;
  private int count;
  private boolean improving;
  private boolean isDeadEnd;
  private boolean found;
  private Configuration best;

  StepTree(CoverageProblem problem, RemainingSets remaining, Stage[] stages) {
    this.problem = problem;
    this.remaining = remaining;
    this.stages = stages;
    marks = new int[problem.maxSets() + 1];
  }

  /**
   * Begins a search.
   *
   * @param ofStages how many stages count
   * @param improve whether to go on when a configuration has been found, with one that is better by
   *     the last stage
   * @param into receives what is found
   */
  void begin(int ofStages, boolean improve, Configuration into) {
    count = ofStages;
    improving = improve;
    best = into;
    found = false;
    isDeadEnd = false;
    depth = 0;
    marks[depth++] = remaining.mark();
    remaining.dropIncluded();
  }

  /** Ends the search: sets that it removed remain again. */
  void end() {
    remaining.undo(marks[0]);
  }

  /** Whether a configuration has been found since {@link #begin}. */
  boolean found() {
    return found;
  }

  @Override
  public boolean isDone() {
    return found && !improving;
  }

  @Override
  public int branch() {
    while (!isDeadEnd) {
      int before = remaining.mark();
      if (!settle(count) || !weigh()) {
        return NONE;
      }
      if (isSure()) {
        keep();
        if (!improving) {
          return NONE;
        }
      } else if (remaining.mark() == before) {
        return mostGaining(fewestSets(scarcest()));
      }
    }
    return NONE;
  }

  /** Lets stages remove sets until none does; false where something required is out of reach. */
  boolean settle(int ofStages) {
    int before;
    do {
      before = remaining.mark();
      for (int stage = 0; stage < ofStages; stage++) {
        if (!stages[stage].narrow()) {
          return false;
        }
      }
    } while (remaining.mark() > before);
    return true;
  }

  private boolean weigh() {
    for (int stage = 0; stage < count; stage++) {
      if (!stages[stage].weigh()) {
        return false;
      }
    }
    return true;
  }

  private boolean isSure() {
    boolean sure = true;
    for (int stage = 0; stage < count; stage++) {
      sure &= stages[stage].isSure();
    }
    return sure;
  }

  private void keep() {
    best.clear();
    for (int camera = 0; camera < problem.cameras(); camera++) {
      best.give(camera, remaining.isOpen(camera) ? mostGaining(camera) : remaining.first(camera));
    }
    found = true;
    if (improving) {
      last().require(last().value(best.coverage()) + last().step());
    }
  }

  private Stage last() {
    return stages[count - 1];
  }

  /** The open target that has fewest cameras to spare; none where it can do without any one. */
  private int scarcest() {
    int scarcest = NONE;
    int fewest = Integer.MAX_VALUE;
    int most = 0;
    for (int target = 0; target < problem.targets(); target++) {
      int choosing = remaining.supply(target) - remaining.sure(target);
      int lack = choosing == 0 ? 0 : last().lack(target);
      int spare = choosing - lack;
      if (lack > 0 && (spare < fewest || (spare == fewest && lack > most))) {
        fewest = spare;
        most = lack;
        scarcest = target;
      }
    }
    return scarcest;
  }

  /** Of the cameras that may hold the target, or any, the one with fewest sets that gains most. */
  private int fewestSets(int target) {
    int chosen = NONE;
    int fewest = Integer.MAX_VALUE;
    for (int i = 0; i < remaining.withChoice(); i++) {
      int camera = remaining.withChoice(i);
      boolean asked = target == NONE || remaining.undecidedOn(camera, target);
      if (asked && remaining.isOpen(camera)) {
        long gain = last().mostGain(camera);
        int sets = gain == 0 ? Integer.MAX_VALUE : remaining.count(camera);
        if (chosen == NONE || sets < fewest || (sets == fewest && gain > last().mostGain(chosen))) {
          fewest = sets;
          chosen = camera;
        }
      }
    }
    return chosen;
  }

  private int mostGaining(int camera) {
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

  /** Removes the set, and the camera's other sets that have nothing more that is still open. */
  @Override
  public void refuse(int set) {
    remaining.undo(marks[--depth]);
    int camera = problem.cameraOf(set);
    for (int other = problem.firstSet(camera); other < problem.endSet(camera); other++) {
      if (other != set && remaining.has(other) && !hasMore(other, set)) {
        remaining.remove(other);
      }
    }
    isDeadEnd = !remaining.remove(set);
  }

  private boolean hasMore(int set, int than) {
    for (int word = 0; word < problem.words(); word++) {
      long more = problem.mask(set, word) & ~problem.mask(than, word);
      for (; more != 0; more &= more - 1) {
        int target = (word << 6) + Long.numberOfTrailingZeros(more);
        for (int stage = 0; stage < count; stage++) {
          if (stages[stage].isOpen(target)) {
            return true;
          }
        }
      }
    }
    return false;
  }
}
