package org.hificamsim.agents.search;

import org.hificamsim.core.metrics.Objective;

/**
 * Solves {@link CoverageProblem}s exactly where a choice is worth the sum over its targets of a
 * {@link Worth}: the objectives {@code covered}, {@code sum} and {@code lexicographic}.
 *
 * <p>{@link ValueClimb} makes a good choice, {@link ValueBounds} bounds what any other is worth,
 * and {@link ValueSearch} closes the gap between them. The order of {@code lexicographic} needs as
 * many worths as its weights do not fit into one number: {@link Stages}. Of equally good choices
 * the result is the one that gives camera 0 its most preferred set, then camera 1, and so on; a
 * search that has not decided after {@value #MAX_NODES} nodes whether a set can be taken counts as
 * a no.
 */
public final class ValueSolver implements Solver {
  static final int MAX_NODES = 1_000;

  private final CoverageProblem problem;
  private final long maxNodes;
  private final Decisions decisions;
  private final Stages stages;
  private final ValueBounds[] bounds;
  private final long[] goals;
  private final ValueClimb climb;
  private final ValueSearch search;
  private final Choice choice;
  private final Choice trial;
  private boolean proven;
  private long most;
  private double value;
  private double bound;

  /** See {@link Solver#of}. */
  ValueSolver(Objective objective, CoverageProblem problem, long maxNodes) {
    this.problem = problem;
    this.maxNodes = maxNodes;
    decisions = new Decisions(problem);
    stages = new Stages(objective, problem, decisions);
    bounds = stages.bounds();
    goals = new long[bounds.length];
    climb = new ValueClimb(problem, bounds);
    search = new ValueSearch(problem, decisions, bounds, goals);
    choice = new Choice(problem);
    trial = new Choice(problem);
  }

  @Override
  public void solve() {
    search.reset();
    choice.reset();
    decisions.reset();
    int count = stages.fill();
    int stage = 0;
    proven = improve(0);
    while (proven && stage + 1 < count) {
      proven = improve(++stage);
    }
    prefer(stage);
    proven &= stages.decide(count, stages.score(choice));
    measure(stage); // where it is not proven, a preferred choice may even be better
  }

  /** Finds the best choice by a stage's worth; returns whether that is proven. */
  private boolean improve(int stage) {
    climb.improve(stage, choice);
    goals[stage] = choice.value(bounds[stage].worth());
    bounds[stage].reset();
    most = bounds[stage].look();
    if (most >= goals[stage] + bounds[stage].worth().step()) {
      most = Math.min(most, bounds[stage].tune());
    }
    return most < goals[stage] + bounds[stage].worth().step()
        || search.improve(stage, maxNodes - search.nodes(), choice);
  }

  private void measure(int stage) {
    value = stages.score(choice);
    bound = proven ? value : Math.max(value, stages.bound(stage, most, choice));
  }

  private void prefer(int stage) {
    for (int camera = 0; camera < problem.cameras(); camera++) {
      int set = problem.firstSet(camera);
      while (set != choice.of(camera) && !swap(camera, set, stage) && !take(camera, set, stage)) {
        set++;
      }
      decisions.decide(camera, choice.of(camera));
    }
  }

  private boolean swap(int camera, int set, int stage) {
    int before = choice.of(camera);
    choice.exchange(camera, set);
    for (int i = 0; i <= stage; i++) {
      if (choice.value(bounds[i].worth()) < goals[i]) {
        choice.exchange(camera, before);
        return false;
      }
    }
    return true;
  }

  private boolean take(int camera, int set, int stage) {
    trial.copy(choice);
    decisions.decide(camera, set);
    boolean taken = search.reach(stage, MAX_NODES, trial);
    decisions.undo();
    if (taken) {
      choice.copy(trial);
    }
    return taken;
  }

  @Override
  public int chosen(int camera) {
    return choice.of(camera);
  }

  /** The score of the last solution. */
  public double value() {
    return value;
  }

  /** What no choice's score exceeds. */
  public double bound() {
    return bound;
  }

  @Override
  public boolean proven() {
    return proven;
  }

  @Override
  public double gap() {
    return bound - value;
  }

  /** The number of search nodes that the last call visited. */
  public long nodes() {
    return search.nodes();
  }
}
