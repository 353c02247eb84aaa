package org.hificamsim.agents.search;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.core.metrics.Objective;

/**
 * Finds the constant configuration with the best score over a run that has been seen: coordinate
 * ascent from the last sets and from {@value #STARTS} random configurations, the same in every run,
 * and {@link BranchAndBound} over the cameras from there.
 *
 * <p>The bound of a partial configuration lets every undecided camera have all its sets at once. A
 * set that another one of the camera includes is left out.
 */
public final class RunSolver extends Solver implements BranchAndBound.Tree {
  private static final int STARTS = 16;

  private final Objective objective;
  private final CoverageProblem problem;
  private final int[] ends;
  private final long maxNodes;
  private final RemainingSets remaining;
  private final Configuration trial;
  private final Configuration best;
  private final int[][] order; // of the sets to try, by camera
  private final double[] bounds; // by set
  private final int[] tried; // by camera; below 0 before its order is known
  private final int[] k; // with all the sets of undecided cameras
  private int depth;
  private double bestScore = -1;

  /**
   * @param problem whose targets are those of all steps that count, step after step
   * @param ends for each step one more than the last of its targets
   * @param maxNodes how many partial configurations may be looked at
   */
  public RunSolver(Objective objective, CoverageProblem problem, int[] ends, long maxNodes) {
    this.objective = objective;
    this.problem = problem;
    this.ends = ends;
    this.maxNodes = maxNodes;
    remaining = new RemainingSets(problem);
    trial = new Configuration(problem);
    best = new Configuration(problem);
    order = new int[problem.cameras()][];
    bounds = new double[problem.sets()];
    tried = new int[problem.cameras() + 1];
    k = new int[problem.targets()];
  }

  @Override
  public void solve() {
    remaining.reset();
    remaining.dropIncluded();
    for (int camera = 0; camera < problem.cameras(); camera++) {
      order[camera] = remaining.sets(camera);
    }
    climb();
    tried[0] = -1;
    System.arraycopy(remaining.supply(), 0, k, 0, k.length);
    double bound = score(k);
    proven = new BranchAndBound().search(this, maxNodes);
    gap = proven ? 0 : bound - bestScore;
  }

  /** One summit may be far below the next where it takes two cameras to gain anything. */
  private void climb() {
    trial.clear();
    for (int camera = 0; camera < problem.cameras(); camera++) {
      trial.give(camera, order[camera][order[camera].length - 1]);
    }
    ascend();
    SplittableRandom random = new SplittableRandom(0);
    boolean choice = Arrays.stream(order).anyMatch(sets -> sets.length > 1);
    for (int start = 0; choice && start < STARTS; start++) {
      for (int camera = 0; camera < problem.cameras(); camera++) {
        trial.exchange(camera, order[camera][random.nextInt(order[camera].length)]);
      }
      ascend();
    }
  }

  /** Changes one camera after the other to its best set, until none gets better. */
  private void ascend() {
    double before;
    double score = score(trial.coverage());
    do {
      before = score;
      for (int camera = 0; camera < problem.cameras(); camera++) {
        score = improve(camera, score);
      }
    } while (score > before);
    keep(score);
  }

  private double improve(int camera, double score) {
    double most = score;
    for (int set : order[camera]) {
      int before = trial.of(camera);
      trial.exchange(camera, set);
      double reached = score(trial.coverage());
      if (reached > most) {
        most = reached;
      } else {
        trial.exchange(camera, before);
      }
    }
    return most;
  }

  private void keep(double score) {
    if (score > bestScore) {
      bestScore = score;
      best.copy(trial);
    }
  }

  /** The sum over the steps of their scores; a step without targets adds 0. */
  private double score(int[] k) {
    double sum = 0;
    int from = 0;
    for (int end : ends) {
      sum += objective.score(k, from, end);
      from = end;
    }
    return sum;
  }

  @Override
  public int branch() {
    if (depth == problem.cameras()) {
      for (int camera = 0; camera < depth; camera++) {
        trial.exchange(camera, order[camera][tried[camera]]);
      }
      keep(score(k));
      return NONE;
    }
    if (tried[depth] < 0) {
      sort();
    }
    int next = tried[depth];
    boolean promising = next < order[depth].length && bounds[order[depth][next]] > bestScore;
    return promising ? order[depth][next] : NONE;
  }

  /** Brings the camera's most promising sets to the front. */
  private void sort() {
    int[] sets = order[depth];
    Arrays.sort(sets);
    for (int i = 0; i < sets.length; i++) {
      int set = sets[i];
      bounds[set] = boundWith(set);
      int at = i;
      for (; at > 0 && bounds[sets[at - 1]] < bounds[set]; at--) {
        sets[at] = sets[at - 1];
      }
      sets[at] = set;
    }
    tried[depth] = 0;
  }

  private double boundWith(int set) {
    decide(depth, set, -1);
    double bound = score(k);
    decide(depth, set, 1);
    return bound;
  }

  /** Takes from the camera what it has at its other sets alone; or, by 1, gives it back. */
  private void decide(int camera, int set, int change) {
    for (int word = 0; word < problem.words(); word++) {
      long lost = remaining.any(camera, word) & ~problem.mask(set, word);
      CoverageProblem.add(k, word, lost, change);
    }
  }

  @Override
  public void take(int set) {
    decide(depth, set, -1);
    depth++;
    tried[depth] = -1;
  }

  @Override
  public void refuse(int set) {
    depth--;
    decide(depth, set, 1);
    tried[depth]++;
  }

  @Override
  public int chosen(int camera) {
    return best.of(camera);
  }
}
