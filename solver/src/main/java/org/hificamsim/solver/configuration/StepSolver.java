package org.hificamsim.solver.configuration;

import org.hificamsim.core.metrics.Objective;
import org.hificamsim.solver.BranchAndBound;

/**
 * Solves {@link CoverageProblem}s exactly, for any objective. One {@link Stage} of the objective
 * after the other, {@link LocalSearch} makes a good configuration, the stage bounds the value of
 * all others, and {@link BranchAndBound} closes the gap; the three take turns with growing effort.
 *
 * <p>Among the best configurations, the result is the one that gives camera 0 its most preferred
 * set, then camera 1, and so on; it does not depend on the order of the search. One exception: a
 * preferred set is passed over if a search of {@value #MAX_TIE_NODES} nodes does not find a best
 * configuration with it.
 *
 * <p>If each camera has a set that includes all its others, nothing needs to be searched.
 */
public final class StepSolver extends Solver {
  static final int MAX_TIE_NODES = 1_000;

  private static final int TIE_PASSES = 3;

  /** Effort of the first round: passes of local search, rounds of prices, and search nodes. */
  private static final int FIRST_PASSES = 4;

  private static final int FIRST_PRICE_ROUNDS = 16;
  private static final int FIRST_NODES = 32;

  private static final int EFFORT_GROWTH = 4;
  private static final int MAX_HEURISTIC_EFFORT = 1 << 10;
  private static final int NONE = -1;

  private final Objective objective;
  private final CoverageProblem problem;
  private final long maxNodes;
  private final RemainingSets remaining;
  private final Stage[] stages;
  private final LocalSearch localSearch;
  private final StepTree tree;
  private final BranchAndBound search = new BranchAndBound();
  private final Configuration best;
  private final Configuration trial;
  private final int[] countedCoverage;

  /**
   * @param problem the problem, which each call of {@link #solve} reads
   * @param maxNodes the number of search nodes after which a call gives up the proof; the search
   *     among equally good configurations has a limit of its own
   */
  public StepSolver(Objective objective, CoverageProblem problem, long maxNodes) {
    this.objective = objective;
    this.problem = problem;
    this.maxNodes = maxNodes;
    remaining = new RemainingSets(problem);
    stages = Stage.stages(objective, problem, remaining);
    localSearch = new LocalSearch(problem, remaining, stages);
    tree = new StepTree(problem, remaining, stages);
    best = new Configuration(problem);
    trial = new Configuration(problem);
    countedCoverage = new int[problem.maxTargets()];
  }

  @Override
  public void solve() {
    search.reset();
    proven = true;
    gap = 0;
    if (takeLargestSets()) {
      for (Stage stage : stages) {
        stage.require(stage.value(best.coverage()));
      }
      preferBySwaps();
    } else {
      improve();
    }
  }

  /** Gives every camera a set that includes all its others; returns false if one has none. */
  private boolean takeLargestSets() {
    best.clear();
    for (int camera = 0; camera < problem.cameras(); camera++) {
      int largest = problem.largestSet(camera);
      if (largest == NONE) {
        return false;
      }
      best.assign(camera, largest);
    }
    return true;
  }

  /** Gives each camera in turn the set that it prefers, as far as the score stays the best. */
  private void preferBySwaps() {
    for (int camera = 0; camera < problem.cameras(); camera++) {
      int set = problem.firstSet(camera);
      while (set != best.set(camera) && !swap(camera, set, stages.length)) {
        set++;
      }
    }
  }

  /** Exchanges a camera's set if the requirements are still met; returns whether they are. */
  private boolean swap(int camera, int set, int stageCount) {
    int before = best.set(camera);
    best.exchange(camera, set);
    for (int stage = 0; stage < stageCount; stage++) {
      if (!stages[stage].isReachedBy(best.coverage())) {
        best.exchange(camera, before);
        return false;
      }
    }
    return true;
  }

  private void improve() {
    best.reset();
    remaining.reset();
    int stageCount = 0;
    while (proven && stageCount < stages.length) {
      proven = improve(++stageCount);
    }
    gap = proven ? 0 : Math.max(0, bound() - score());
    preferBySearch(stageCount);
  }

  /**
   * Improves the configuration by the last of some stages, and keeps its value of the earlier ones.
   *
   * <p>What the stage requires changes on the way, because local search, prices and tree all read
   * it: first the bound, as a goal for local search; then the next value above the best one, which
   * the proof shows to be out of reach; at last the value reached, which later stages have to keep.
   *
   * @return whether its value is proven to be the best
   */
  private boolean improve(int stageCount) {
    Stage stage = stages[stageCount - 1];
    stage.reset();
    long bound = stage.bound();
    long value = stage.value(best.coverage());
    if (value < bound) {
      stage.require(bound);
      localSearch.improve(stageCount, FIRST_PASSES, best);
      value = stage.value(best.coverage());
    }
    boolean done = value == bound || closeGap(stageCount, bound);
    stage.require(stage.value(best.coverage()));
    return done;
  }

  /**
   * Looks for a proof that nothing is better, with more and more effort. The value is the best if
   * it equals the bound, if prices show that the next value is out of reach, or if the tree of all
   * configurations with that value was searched to its end.
   *
   * @return whether there is a proof; there is at least one attempt, even if no nodes are left
   */
  private boolean closeGap(int stageCount, long bound) {
    Stage stage = stages[stageCount - 1];
    int mark = remaining.mark();
    remaining.removeIncluded();
    boolean done = false;
    for (long effort = 1;
        !done && (effort == 1 || search.nodes() < maxNodes);
        effort *= EFFORT_GROWTH) {
      int heuristicEffort = (int) Math.min(effort, MAX_HEURISTIC_EFFORT);
      if (effort > 1) {
        stage.require(bound);
        localSearch.improve(stageCount, FIRST_PASSES * heuristicEffort, best);
      }
      long value = stage.value(best.coverage());
      stage.require(value + stage.step());
      done =
          value == bound
              || !stage.tunePrices(FIRST_PRICE_ROUNDS * heuristicEffort)
              || searchBetter(
                  stageCount, Math.min(FIRST_NODES * effort, maxNodes - search.nodes()));
    }
    remaining.undo(mark);
    return done;
  }

  /** Searches for better configurations; returns whether the tree was searched to its end. */
  private boolean searchBetter(int stageCount, long nodes) {
    tree.beginImproving(stageCount, best);
    boolean complete = search.search(tree, nodes);
    tree.end();
    return complete;
  }

  /** An upper bound of the score, when a stage is not proven. */
  private double bound() {
    Stage first = stages[0];
    return Math.min(
        score(remaining.maxCoverage()),
        objective.scoreAtMost(first.inUnits(first.bound()), problem.targets()));
  }

  /** The score of the last solution. */
  public double score() {
    return score(best.coverage());
  }

  private double score(int[] coverage) {
    int count = 0;
    for (int target = 0; target < problem.targets(); target++) {
      if (!objective.countsCoverableOnly() || problem.isCoverable(target)) {
        countedCoverage[count++] = coverage[target];
      }
    }
    return objective.score(countedCoverage, 0, count);
  }

  /** Gives each camera in turn the set that it prefers, if a search shows that this is possible. */
  private void preferBySearch(int stageCount) {
    tree.narrow(stageCount);
    for (int i = 0; i < remaining.choosingCameras(); i++) {
      preferBySearch(remaining.choosingCamera(i), stageCount);
    }
  }

  private void preferBySearch(int camera, int stageCount) {
    int set = remaining.first(camera);
    while (set != best.set(camera)
        && !swap(camera, set, stageCount)
        && !findWith(set, stageCount)) {
      remaining.remove(set);
      set = remaining.first(camera);
    }
    remaining.choose(set);
    tree.narrow(stageCount);
  }

  /** Looks for a configuration with a set that meets all requirements, and makes it the best. */
  private boolean findWith(int set, int stageCount) {
    int mark = remaining.mark();
    remaining.choose(set);
    boolean found = false;
    if (tree.narrow(stageCount)) {
      trial.copy(best, remaining);
      found = localSearch.improve(stageCount, TIE_PASSES, trial) || searchAny(stageCount, trial);
    }
    remaining.undo(mark);
    if (found) {
      best.copy(trial);
    }
    return found;
  }

  private boolean searchAny(int stageCount, Configuration result) {
    tree.beginFinding(stageCount, result);
    search.search(tree, MAX_TIE_NODES);
    tree.end();
    return tree.found();
  }

  @Override
  public int chosen(int camera) {
    return best.set(camera);
  }

  /** The number of search nodes that the last call of {@link #solve} visited. */
  public long nodes() {
    return search.nodes();
  }
}
