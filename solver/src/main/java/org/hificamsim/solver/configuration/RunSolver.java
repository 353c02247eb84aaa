package org.hificamsim.solver.configuration;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.solver.BitMatrix;

/**
 * Finds the constant configuration with the best score over a finished run. Coordinate ascent, from
 * every camera's last set and from {@value #STARTS} random configurations with a fixed seed, finds
 * a good one; {@link BranchAndBound} over the cameras improves it or proves it the best.
 *
 * <p>The bound of a partial configuration lets every undecided camera use all its sets at once.
 * Sets that another set of the camera includes are left out.
 */
public final class RunSolver extends Solver implements BranchAndBound.Tree {
  private static final int STARTS = 16;
  private static final int UNSORTED = -1;

  private final Objective objective;
  private final CoverageProblem problem;
  private final int[] ends;
  private final long maxNodes;
  private final RemainingSets remaining;
  private final Configuration trial;
  private final Configuration best;

  /** The sets to try, by camera; those of decided cameras with the greatest bound first. */
  private final int[][] setsToTry;

  /** The bound of the score with a set and the decisions before it, by set. */
  private final double[] bounds;

  /** The index of each camera in {@link #setsToTry}; {@link #UNSORTED} before these are sorted. */
  private final int[] triedIndex;

  /** The number of cameras that cover each target if undecided cameras use all their sets. */
  private final int[] optimisticCoverage;

  private int depth;
  private double bestScore = -1;

  /**
   * @param problem the problem, whose targets are those of all steps that count, step after step
   * @param ends for each step, the end of its targets, exclusive
   * @param maxNodes the number of partial configurations after which the proof is given up
   */
  public RunSolver(Objective objective, CoverageProblem problem, int[] ends, long maxNodes) {
    this.objective = objective;
    this.problem = problem;
    this.ends = ends;
    this.maxNodes = maxNodes;
    remaining = new RemainingSets(problem);
    trial = new Configuration(problem);
    best = new Configuration(problem);
    setsToTry = new int[problem.cameras()][];
    bounds = new double[problem.sets()];
    triedIndex = new int[problem.cameras() + 1];
    optimisticCoverage = new int[problem.targets()];
  }

  @Override
  public void solve() {
    remaining.reset();
    remaining.removeIncluded();
    for (int camera = 0; camera < problem.cameras(); camera++) {
      setsToTry[camera] = remaining.sets(camera);
    }
    climb();
    triedIndex[0] = UNSORTED;
    System.arraycopy(remaining.maxCoverage(), 0, optimisticCoverage, 0, optimisticCoverage.length);
    double bound = score(optimisticCoverage);
    proven = new BranchAndBound().search(this, maxNodes);
    gap = proven ? 0 : bound - bestScore;
  }

  /**
   * Starts from many configurations: where only a change of two cameras gains anything, one ascent
   * may end far below the best.
   */
  private void climb() {
    trial.clear();
    for (int camera = 0; camera < problem.cameras(); camera++) {
      trial.assign(camera, setsToTry[camera][setsToTry[camera].length - 1]);
    }
    ascend();
    SplittableRandom random = new SplittableRandom(0);
    boolean choice = Arrays.stream(setsToTry).anyMatch(sets -> sets.length > 1);
    for (int start = 0; choice && start < STARTS; start++) {
      for (int camera = 0; camera < problem.cameras(); camera++) {
        trial.exchange(camera, setsToTry[camera][random.nextInt(setsToTry[camera].length)]);
      }
      ascend();
    }
  }

  /** Gives one camera after the other its best set until no change improves the score. */
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
    double greatest = score;
    for (int set : setsToTry[camera]) {
      int before = trial.set(camera);
      trial.exchange(camera, set);
      double changed = score(trial.coverage());
      if (changed > greatest) {
        greatest = changed;
      } else {
        trial.exchange(camera, before);
      }
    }
    return greatest;
  }

  private void keep(double score) {
    if (score > bestScore) {
      bestScore = score;
      best.copy(trial);
    }
  }

  /** The sum of all steps' scores; a step without targets adds 0. */
  private double score(int[] coverage) {
    double sum = 0;
    int from = 0;
    for (int end : ends) {
      sum += objective.score(coverage, from, end);
      from = end;
    }
    return sum;
  }

  @Override
  public int branch() {
    if (depth == problem.cameras()) {
      for (int camera = 0; camera < depth; camera++) {
        trial.exchange(camera, setsToTry[camera][triedIndex[camera]]);
      }
      keep(score(optimisticCoverage));
      return NONE;
    }
    if (triedIndex[depth] == UNSORTED) {
      sort();
    }
    int next = triedIndex[depth];
    boolean promising =
        next < setsToTry[depth].length && bounds[setsToTry[depth][next]] > bestScore;
    return promising ? setsToTry[depth][next] : NONE;
  }

  /** Sorts the sets of the next camera by their bounds, the greatest first. */
  private void sort() {
    int[] sets = setsToTry[depth];
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
    triedIndex[depth] = 0;
  }

  private double boundWith(int set) {
    countLost(depth, set, -1);
    double bound = score(optimisticCoverage);
    countLost(depth, set, 1);
    return bound;
  }

  /**
   * Removes the targets that only other sets of the camera hold from the optimistic coverage
   * ({@code change} -1), or adds them again (1).
   */
  private void countLost(int camera, int set, int change) {
    for (int word = 0; word < problem.words(); word++) {
      long lost = remaining.union(camera, word) & ~problem.mask(set, word);
      BitMatrix.add(optimisticCoverage, word, lost, change);
    }
  }

  @Override
  public void take(int set) {
    countLost(depth, set, -1);
    depth++;
    triedIndex[depth] = UNSORTED;
  }

  @Override
  public void refuse(int set) {
    depth--;
    countLost(depth, set, 1);
    triedIndex[depth]++;
  }

  @Override
  public int chosen(int camera) {
    return best.set(camera);
  }
}
