package org.hificamsim.solver.way;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.metrics.Objective;

/** A random problem of ways, small enough to try all of them. */
final class RandomWays {
  private static final int STEPS = 4;
  private static final int VIEWS = 3;

  private final SplittableRandom random;
  final List<TravelTimes> times = new ArrayList<>();
  private final List<BitSet> online = new ArrayList<>();
  private final List<BitSet[]> detected = new ArrayList<>();
  private final int[] ends = new int[STEPS];
  private final int cameras;
  final WayProblem problem;

  /**
   * Makes a random problem, in which cameras need some steps from one view on a line to the next,
   * and one may be off for a while.
   */
  RandomWays(long seed, Objective objective) {
    random = new SplittableRandom(seed);
    cameras = 1 + random.nextInt(3);
    for (int step = 0; step < STEPS; step++) {
      ends[step] = (step == 0 ? 0 : ends[step - 1]) + random.nextInt(4);
    }
    for (int camera = 0; camera < cameras; camera++) {
      addCamera(random.nextInt(3));
    }
    problem = new WayProblem(objective, ends, times, online, detected);
  }

  private void addCamera(int slowness) {
    int[] blind = new int[VIEWS * VIEWS];
    for (int i = 0; i < blind.length; i++) {
      blind[i] = Math.max(0, slowness * Math.abs(i / VIEWS - i % VIEWS) - 1);
    }
    times.add(new TravelTimes(random.nextInt(VIEWS), VIEWS, blind));
    BitSet steps = new BitSet();
    steps.set(0, STEPS);
    steps.set(random.nextInt(STEPS), random.nextBoolean());
    online.add(steps);
    BitSet[] views = new BitSet[VIEWS];
    Arrays.setAll(views, view -> randomMoments(steps));
    detected.add(views);
  }

  private BitSet randomMoments(BitSet steps) {
    BitSet moments = new BitSet();
    for (int step = 0; step < STEPS; step++) {
      for (int moment = step == 0 ? 0 : ends[step - 1]; moment < ends[step]; moment++) {
        moments.set(moment, steps.get(step) && random.nextInt(5) < 2);
      }
    }
    return moments;
  }

  /** The best score of all ways: every camera may be sent to any view in any step. */
  double bestOfAll() {
    return best(0, new int[problem.momentCount()]);
  }

  private double best(int camera, int[] coverage) {
    if (camera == cameras) {
      return problem.score(coverage);
    }
    double best = 0;
    for (int code = 0; code < Math.pow(VIEWS, STEPS); code++) {
      int[] seen = follow(camera, code);
      count(seen, 1, coverage);
      best = Math.max(best, best(camera + 1, coverage));
      count(seen, -1, coverage);
    }
    return best;
  }

  /** Sends a camera to the goals of a code; a goal that changes during a move is ignored. */
  private int[] follow(int camera, int code) {
    int[] goals = new int[STEPS];
    for (int step = 0; step < STEPS; step++) {
      goals[step] = code % VIEWS;
      code /= VIEWS;
    }
    return seen(camera, goals);
  }

  /** Returns the set that a camera detects in each step if it is sent to these views. */
  int[] seen(int camera, int[] goals) {
    TravelTimes travel = times.get(camera);
    int[] seen = new int[STEPS];
    int view = travel.home();
    int goal = view;
    int left = 0;
    for (int step = 0; step < STEPS; step++) {
      if (online.get(camera).get(step)) {
        if (left == 0 && goals[step] != view) {
          goal = goals[step];
          left = travel.blindSteps(view, goal) + 1;
        }
        left -= left > 0 ? 1 : 0;
        view = left == 0 ? goal : view;
        seen[step] = left == 0 ? problem.set(camera, step, view) : WayProblem.NOTHING;
      }
    }
    return seen;
  }

  private void count(int[] seen, int change, int[] coverage) {
    for (int set : seen) {
      for (int moment : problem.moments(set)) {
        coverage[moment] += change;
      }
    }
  }

  /** The score if each camera is sent to its goals. */
  double score(WaySolver solver) {
    int[] coverage = new int[problem.momentCount()];
    for (int camera = 0; camera < cameras; camera++) {
      count(seen(camera, solver.goals(camera)), 1, coverage);
    }
    return problem.score(coverage);
  }

  /** The sum over the steps of the best score if cameras jump. */
  double bestOfJumps() {
    List<TravelTimes> instantTimes =
        times.stream()
            .map(time -> new TravelTimes(time.home(), VIEWS, new int[VIEWS * VIEWS]))
            .toList();
    double sum = 0;
    WayProblem jumping = new WayProblem(problem.objective(), ends, instantTimes, online, detected);
    for (int step = 0; step < STEPS; step++) {
      sum += bestOfStep(jumping, step, 0, new int[problem.momentCount()]);
    }
    return sum;
  }

  private double bestOfStep(WayProblem jumping, int step, int camera, int[] coverage) {
    if (camera == cameras) {
      return jumping.objective().score(coverage, jumping.start(step), jumping.end(step));
    }
    double best = bestOfStep(jumping, step, camera + 1, coverage);
    for (int set = jumping.firstSet(step, camera); set < jumping.endSet(step, camera); set++) {
      count(new int[] {set}, 1, coverage);
      best = Math.max(best, bestOfStep(jumping, step, camera + 1, coverage));
      count(new int[] {set}, -1, coverage);
    }
    return best;
  }
}
