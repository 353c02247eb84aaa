package org.hificamsim.solver.way;

import java.util.Arrays;

/** The way of each camera: where it is sent, and what it detects, in each step. */
final class CameraWays {
  private final WayProblem problem;

  /** The view that a camera is sent to, by camera and step. */
  private final int[][] goals;

  /** The set that a camera detects, by camera and step. */
  private final int[][] seen;

  CameraWays(WayProblem problem) {
    this.problem = problem;
    goals = new int[problem.cameras()][problem.steps()];
    seen = new int[problem.cameras()][problem.steps()];
    for (int camera = 0; camera < problem.cameras(); camera++) {
      Arrays.fill(goals[camera], problem.times(camera).home());
    }
  }

  int[] goals(int camera) {
    return goals[camera];
  }

  int[] seen(int camera) {
    return seen[camera];
  }

  void copy(CameraWays other) {
    for (int camera = 0; camera < goals.length; camera++) {
      System.arraycopy(other.goals[camera], 0, goals[camera], 0, goals[camera].length);
      System.arraycopy(other.seen[camera], 0, seen[camera], 0, seen[camera].length);
    }
  }

  /** Adds a camera's detections to the coverage of moments, or takes them away (-1). */
  void count(int camera, int change, int[] coverage) {
    for (int set : seen[camera]) {
      for (int moment : problem.moments(set)) {
        coverage[moment] += change;
      }
    }
  }

  int[] coverage() {
    int[] coverage = new int[problem.momentCount()];
    for (int camera = 0; camera < goals.length; camera++) {
      count(camera, 1, coverage);
    }
    return coverage;
  }
}
