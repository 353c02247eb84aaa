package org.hificamsim.solver.way;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.solver.Exchange;

/**
 * Plans in turns: each camera in turn takes its best way given the ways of the others, until none
 * gains. Progress towards a gain counts less from pass to pass.
 */
final class TurnPlanner implements Exchange.Choice {
  private static final double[] SHARES = {0.5, 0.1, 1e-3};
  private static final int MAX_PASSES = 6;

  private final WayProblem problem;
  private final MostRewardingWay search;
  private final StepGuide guide;
  private final double[] rewards;
  private final CameraWays trial;
  private final CameraWays best;
  private int[] coverage;
  private int[] turns;
  private double share;
  private double score;
  private double bestScore = -1;

  TurnPlanner(WayProblem problem) {
    this.problem = problem;
    search = new MostRewardingWay(problem);
    guide = new StepGuide(problem);
    rewards = new double[problem.sets()];
    trial = new CameraWays(problem);
    best = new CameraWays(problem);
  }

  /** Plans from cameras without a way, in the order of a seed; 0 keeps their numbers. */
  void planFromNothing(long seed) {
    for (int camera = 0; camera < problem.cameras(); camera++) {
      Arrays.fill(trial.seen(camera), WayProblem.NOTHING);
    }
    plan(order(seed), 0);
  }

  /** Plans from given ways; progress counts from the first or a later share on. */
  void planFrom(CameraWays ways, long seed, int firstShare) {
    trial.copy(ways);
    plan(order(seed), firstShare);
  }

  private int[] order(long seed) {
    int[] order = new int[problem.cameras()];
    Arrays.setAll(order, camera -> camera);
    SplittableRandom random = new SplittableRandom(seed);
    for (int i = order.length - 1; seed != 0 && i > 0; i--) {
      int other = random.nextInt(i + 1);
      int camera = order[i];
      order[i] = order[other];
      order[other] = camera;
    }
    return order;
  }

  private void plan(int[] order, int firstShare) {
    turns = order;
    coverage = trial.coverage();
    for (int i = firstShare; i < SHARES.length; i++) {
      share = SHARES[i];
      score = -1;
      Exchange.improve(this, MAX_PASSES);
    }
  }

  @Override
  public int choosers() {
    return turns.length;
  }

  @Override
  public boolean endPass(boolean changed) {
    double before = score;
    score = problem.score(coverage);
    keep(score);
    return score > before;
  }

  private void keep(double newScore) {
    if (newScore > bestScore) {
      bestScore = newScore;
      best.copy(trial);
    }
  }

  @Override
  public boolean exchange(int turn) {
    int camera = turns[turn];
    trial.count(camera, -1, coverage);
    for (int step : problem.onlineSteps(camera)) {
      for (int set = problem.firstSet(step, camera); set < problem.endSet(step, camera); set++) {
        rewards[set] = guide.gain(step, set, coverage, share);
      }
    }
    search.search(camera, rewards, trial);
    trial.count(camera, 1, coverage);
    return true;
  }

  CameraWays best() {
    return best;
  }

  double bestScore() {
    return bestScore;
  }
}
