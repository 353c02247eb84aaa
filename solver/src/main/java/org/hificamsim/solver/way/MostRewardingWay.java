package org.hificamsim.solver.way;

import java.util.Arrays;

/**
 * Finds a camera's way with the greatest sum of rewards for the sets that it detects: dynamic
 * programming over the steps in which it is online and the views in which it has arrived. Among
 * equal ways, it prefers one that stays in its view.
 */
final class MostRewardingWay {
  private static final int START = -1;

  private final WayProblem problem;

  /** The greatest sum of a way that is in the view, by own step and view. */
  private double[] sums = {};

  /** The view before, by own step and view. */
  private int[] before = {};

  private int camera;
  private TravelTimes times;
  private int[] steps;

  MostRewardingWay(WayProblem problem) {
    this.problem = problem;
  }

  /**
   * Writes the camera's best way.
   *
   * @param rewards the reward of each set, 0 or more
   * @return the sum of its rewards
   */
  double search(int newCamera, double[] rewards, CameraWays ways) {
    camera = newCamera;
    times = problem.times(camera);
    steps = problem.onlineSteps(camera);
    Arrays.fill(ways.seen(camera), WayProblem.NOTHING);
    if (steps.length == 0) {
      return 0;
    }
    if (sums.length < steps.length * times.views()) {
      sums = new double[steps.length * times.views()];
      before = new int[steps.length * times.views()];
    }
    for (int step = 0; step < steps.length; step++) {
      for (int view = 0; view < times.views(); view++) {
        arrive(step, view, rewards);
      }
    }
    return trace(ways);
  }

  private void arrive(int step, int view, double[] rewards) {
    double best = sum(step - 1, view);
    int from = view;
    for (int other = 0; other < times.views(); other++) {
      double sum = sum(step - 1 - times.blindSteps(other, view), other);
      if (sum > best) {
        best = sum;
        from = other;
      }
    }
    sums[step * times.views() + view] = best + rewards[problem.set(camera, steps[step], view)];
    before[step * times.views() + view] = from;
  }

  private double sum(int step, int view) {
    if (step >= 0) {
      return sums[step * times.views() + view];
    }
    return step == START && view == times.home() ? 0 : Double.NEGATIVE_INFINITY;
  }

  private double trace(CameraWays ways) {
    int step = steps.length - 1;
    int view = 0;
    for (int other = 1; other < times.views(); other++) {
      view = sum(step, other) > sum(step, view) ? other : view;
    }
    double best = sum(step, view);
    while (step >= 0) {
      ways.seen(camera)[steps[step]] = problem.set(camera, steps[step], view);
      int from = before[step * times.views() + view];
      int arrived = step - 1 - times.blindSteps(from, view);
      for (; step > arrived; step--) {
        ways.goals(camera)[steps[step]] = view;
      }
      view = from;
    }
    return best;
  }
}
