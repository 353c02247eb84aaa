package org.hificamsim.agents.search;

import java.util.List;
import org.hificamsim.core.metrics.Objective;

/**
 * Solves {@link CoverageProblem}s exactly, by any objective: stage after stage, {@link LocalSearch}
 * makes a good configuration, a {@link Stage} bounds what any other is worth, and {@link
 * BranchAndBound} closes the gap between them; they take turns with growing effort.
 *
 * <p>Of the best configurations the result is the one that gives camera 0 its most preferred set,
 * then camera 1, and so on: it does not depend on how the search went. Only where a search has not
 * decided after {@value #MAX_TIE_NODES} nodes whether a preferred set can be had, that counts as a
 * no. Where each camera has a set that holds all its others, nothing has to be searched.
 */
public final class StepSolver extends Solver {
  static final int MAX_TIE_NODES = 1_000;

  private static final int TIE_PASSES = 3;
  private static final int PASSES = 4;
  private static final int ROUNDS = 16;
  private static final int NODES = 32;
  private static final int GROWTH = 4;
  private static final int MAX_HEURISTIC_EFFORT = 1 << 10;
  private static final int NONE = -1;

  private final Objective objective;
  private final CoverageProblem problem;
  private final long maxNodes;
  private final RemainingSets remaining;
  private final Stage[] stages;
  private final LocalSearch local;
  private final StepTree tree;
  private final BranchAndBound search = new BranchAndBound();
  private final Configuration best;
  private final Configuration trial;
  private final int[] counting; // k of the targets that count

  /**
   * @param problem what each call of {@link #solve} reads
   * @param maxNodes number of search nodes after which a call gives up the proof; the search among
   *     equally good configurations has a limit of its own
   */
  public StepSolver(Objective objective, CoverageProblem problem, long maxNodes) {
    this.objective = objective;
    this.problem = problem;
    this.maxNodes = maxNodes;
    remaining = new RemainingSets(problem);
    stages = stages(objective, problem, remaining);
    local = new LocalSearch(problem, remaining, stages);
    tree = new StepTree(problem, remaining, stages);
    best = new Configuration(problem);
    trial = new Configuration(problem);
    counting = new int[problem.maxTargets()];
  }

  static Stage[] stages(Objective objective, CoverageProblem problem, RemainingSets remaining) {
    double sums = LocalSearch.MAX_NEED * (problem.maxCameras() + 2.0) * (problem.maxTargets() + 1);
    List<long[]> worths = objective.worths(problem.maxCameras(), problem.maxTargets());
    return worths.stream()
        .map(table -> new TargetWorth(table, sums))
        .map(worth -> new Stage(problem, remaining, worth, objective.byLeast()))
        .toArray(Stage[]::new);
  }

  @Override
  public void solve() {
    search.reset();
    proven = true;
    gap = 0;
    if (takeWholeSets()) {
      for (Stage stage : stages) {
        stage.require(stage.value(best.coverage()));
      }
      preferBySwaps();
    } else {
      improve();
    }
  }

  /** Gives every camera a set that holds all its others; false when one has none. */
  private boolean takeWholeSets() {
    best.clear();
    for (int camera = 0; camera < problem.cameras(); camera++) {
      int whole = problem.wholeSet(camera);
      if (whole == NONE) {
        return false;
      }
      best.give(camera, whole);
    }
    return true;
  }

  /** Every camera in turn has what it prefers if the whole sets of those after it allow it. */
  private void preferBySwaps() {
    for (int camera = 0; camera < problem.cameras(); camera++) {
      int set = problem.firstSet(camera);
      while (set != best.of(camera) && !swap(camera, set, stages.length)) {
        set++;
      }
    }
  }

  private boolean swap(int camera, int set, int count) {
    int before = best.of(camera);
    best.exchange(camera, set);
    for (int stage = 0; stage < count; stage++) {
      if (!stages[stage].isReached(best.coverage())) {
        best.exchange(camera, before);
        return false;
      }
    }
    return true;
  }

  private void improve() {
    best.reset();
    remaining.reset();
    int count = 0;
    while (proven && count < stages.length) {
      proven = improve(++count);
    }
    gap = proven ? 0 : Math.max(0, bound() - score());
    prefer(count);
  }

  /** Finds the best configuration by a stage; returns whether that is proven. */
  private boolean improve(int count) {
    Stage stage = stages[count - 1];
    stage.reset();
    long bound = stage.bound();
    long value = stage.value(best.coverage());
    if (value < bound) {
      stage.require(bound);
      local.reach(count, PASSES, best);
      value = stage.value(best.coverage());
    }
    boolean done = value == bound || closeGap(count, bound);
    stage.require(stage.value(best.coverage()));
    return done;
  }

  private boolean closeGap(int count, long bound) {
    Stage stage = stages[count - 1];
    int mark = remaining.mark();
    remaining.dropIncluded();
    boolean done = false;
    for (long effort = 1; !done && (effort == 1 || search.nodes() < maxNodes); effort *= GROWTH) {
      int heuristicEffort = (int) Math.min(effort, MAX_HEURISTIC_EFFORT);
      if (effort > 1) {
        stage.require(bound);
        local.reach(count, PASSES * heuristicEffort, best);
      }
      long value = stage.value(best.coverage());
      stage.require(value + stage.step());
      done =
          value == bound
              || !stage.tune(ROUNDS * heuristicEffort)
              || search(count, true, Math.min(NODES * effort, maxNodes - search.nodes()), best);
    }
    remaining.undo(mark);
    stage.priceSets();
    return done;
  }

  private boolean search(int count, boolean improving, long nodes, Configuration found) {
    tree.begin(count, improving, found);
    boolean all = search.search(tree, nodes);
    tree.end();
    return all;
  }

  /** What no score exceeds where a stage is not proven. */
  private double bound() {
    Stage first = stages[0];
    return Math.min(
        score(remaining.supply()),
        objective.scoreAtMost(first.inUnits(first.bound()), problem.targets()));
  }

  /** The score of the last solution. */
  public double score() {
    return score(best.coverage());
  }

  private double score(int[] coverage) {
    int count = 0;
    for (int target = 0; target < problem.targets(); target++) {
      if (!objective.ofCoverableAlone() || problem.isCoverable(target)) {
        counting[count++] = coverage[target];
      }
    }
    return objective.score(counting, 0, count);
  }

  private void prefer(int count) {
    tree.settle(count);
    for (int i = 0; i < remaining.withChoice(); i++) {
      prefer(remaining.withChoice(i), count);
    }
  }

  private void prefer(int camera, int count) {
    int set = remaining.first(camera);
    while (set != best.of(camera) && !swap(camera, set, count) && !take(set, count)) {
      remaining.remove(set);
      set = remaining.first(camera);
    }
    remaining.choose(set);
    tree.settle(count);
  }

  private boolean take(int set, int count) {
    int mark = remaining.mark();
    remaining.choose(set);
    boolean taken = false;
    if (tree.settle(count)) {
      trial.copy(best, remaining);
      taken = local.reach(count, TIE_PASSES, trial);
      if (!taken) {
        search(count, false, MAX_TIE_NODES, trial);
        taken = tree.found();
      }
    }
    remaining.undo(mark);
    if (taken) {
      best.copy(trial);
    }
    return taken;
  }

  @Override
  public int chosen(int camera) {
    return best.of(camera);
  }

  /** The number of search nodes that the last call visited. */
  public long nodes() {
    return search.nodes();
  }
}
