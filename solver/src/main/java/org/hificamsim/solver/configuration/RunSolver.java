package org.hificamsim.solver.configuration;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.solver.BitMatrix;
import org.hificamsim.solver.BranchAndBound;
import org.hificamsim.solver.BranchList;
import org.hificamsim.solver.Exchange;

/**
 * Finds the constant configuration with the best score over a finished run. Coordinate ascent, from
 * every camera's last set and from {@value #STARTS} random configurations with a fixed seed, finds
 * a good one; {@link BranchAndBound} over the cameras improves it or proves it the best.
 *
 * <p>The bound of a partial configuration lets every undecided camera use all its sets at once.
 * Sets that another set of the camera includes are left out.
 */
public final class RunSolver extends Solver implements BranchList.Problem, Exchange.Choice {
  private static final int STARTS = 16;

  private final Objective objective;
  private final CoverageProblem problem;
  private final int[] ends;
  private final long maxNodes;
  private final RemainingSets remaining;
  private final Configuration trial;
  private final Configuration best;

  /** The sets to try, by camera. */
  private final int[][] setsToTry;

  /** The sets of the camera whose number is the depth, those with the greatest bound first. */
  private final BranchList branches;

  /** The number of cameras that cover each target if undecided cameras use all their sets. */
  private final int[] optimisticCoverage;

  private double trialScore;
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
    branches = new BranchList(this, problem.cameras());
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
    System.arraycopy(remaining.maxCoverage(), 0, optimisticCoverage, 0, optimisticCoverage.length);
    double bound = score(optimisticCoverage);
    branches.begin();
    proven = new BranchAndBound().search(branches, maxNodes);
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
    trialScore = score(trial.coverage());
    Exchange.improve(this, Exchange.UNLIMITED);
    keep(trialScore);
  }

  @Override
  public int choosers() {
    return problem.cameras();
  }

  @Override
  public boolean exchange(int camera) {
    double before = trialScore;
    for (int set : setsToTry[camera]) {
      int setBefore = trial.set(camera);
      trial.exchange(camera, set);
      double changed = score(trial.coverage());
      if (changed > trialScore) {
        trialScore = changed;
      } else {
        trial.exchange(camera, setBefore);
      }
    }
    return trialScore > before;
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
  public void list(int camera) {
    if (camera == problem.cameras()) {
      for (int decided = 0; decided < camera; decided++) {
        trial.exchange(decided, branches.taken(decided));
      }
      keep(score(optimisticCoverage));
      return;
    }
    for (int set : setsToTry[camera]) {
      branches.add(set, boundWith(camera, set));
    }
  }

  @Override
  public boolean isPromising(int camera, int set) {
    return branches.value(camera) > bestScore;
  }

  private double boundWith(int camera, int set) {
    countLost(camera, set, -1);
    double bound = score(optimisticCoverage);
    countLost(camera, set, 1);
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
  public void take(int camera, int set) {
    countLost(camera, set, -1);
  }

  @Override
  public void undo(int camera, int set) {
    countLost(camera, set, 1);
  }

  @Override
  public int chosen(int camera) {
    return best.set(camera);
  }
}
