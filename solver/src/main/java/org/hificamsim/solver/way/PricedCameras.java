package org.hificamsim.solver.way;

import java.util.Arrays;

/**
 * The cameras of a step whose sets may be worth their prices, split into groups that share no
 * target: each group is a problem of its own.
 */
final class PricedCameras {
  private static final double TOLERANCE = 1e-12;

  private final WayProblem problem;

  /** The sets of each camera that may be worth their prices. */
  private final int[][] sets;

  private final int[] setCounts;

  /** A camera that may detect the target, or -1, by moment of the step. */
  private final int[] cameraOf;

  /** Another camera of the same group, or the camera itself, by camera. */
  private final int[] leader;

  /** The number of cameras of the step that may detect the target, by moment of the run. */
  private final int[] maxCoverage;

  private final int[] lastCamera;

  PricedCameras(WayProblem problem) {
    this.problem = problem;
    sets = new int[problem.cameras()][];
    setCounts = new int[problem.cameras()];
    for (int camera = 0; camera < sets.length; camera++) {
      sets[camera] = new int[problem.times(camera).views()];
    }
    cameraOf = new int[problem.maxMoments()];
    leader = new int[problem.cameras()];
    maxCoverage = problem.coverable();
    lastCamera = new int[problem.maxMoments()];
  }

  /** Selects the sets of a step, and groups its cameras. */
  void fill(int step, double[] prices, StepWorth worth) {
    Arrays.fill(cameraOf, -1);
    Arrays.fill(lastCamera, -1);
    int start = problem.start(step);
    Arrays.fill(maxCoverage, start, problem.end(step), 0);
    for (int camera = 0; camera < leader.length; camera++) {
      leader[camera] = camera;
      setCounts[camera] = 0;
      for (int set = problem.firstSet(step, camera); set < problem.endSet(step, camera); set++) {
        double most = worth.greatestGain(leader.length) * problem.moments(set).length;
        if (prices[set] < most - TOLERANCE) {
          sets[camera][setCounts[camera]++] = set;
          join(camera, set, start);
        }
      }
    }
  }

  private void join(int camera, int set, int start) {
    for (int moment : problem.moments(set)) {
      int index = moment - start;
      maxCoverage[moment] += lastCamera[index] == camera ? 0 : 1;
      lastCamera[index] = camera;
      if (cameraOf[index] < 0) {
        cameraOf[index] = camera;
      } else {
        leader[group(camera)] = group(cameraOf[index]);
      }
    }
  }

  /** The number of a camera's group: that of one of its cameras. */
  int group(int camera) {
    int first = camera;
    while (leader[first] != first) {
      first = leader[first];
    }
    return first;
  }

  int setCount(int camera) {
    return setCounts[camera];
  }

  int set(int camera, int index) {
    return sets[camera][index];
  }

  void remove(int camera, int index) {
    sets[camera][index] = sets[camera][--setCounts[camera]];
  }

  int maxCoverage(int moment) {
    return maxCoverage[moment];
  }
}
