package org.hificamsim.presentation.replay;

import com.fasterxml.jackson.annotation.JsonInclude;
import org.hificamsim.core.metrics.CoveredTargets;
import org.hificamsim.core.metrics.StepCoverage;

/**
 * What one step left: a copy, not a view. Arrays are indexed by the numbers of cameras and targets
 * in the {@link Setup}; the values of a camera that is not online, or of a target that is not
 * present, mean nothing.
 *
 * @param level by camera, the view that it chose last; where it cannot turn, its zoom level: 0 is
 *     the narrowest
 * @param detected by camera, number of targets
 * @param x by target, metres, where the cameras observed it
 * @param y by target, metres
 * @param coverage by target, the number of cameras that detect it: k_j of thesis 7.1
 * @param estimates by camera and view, what the agent knows, NaN where nothing; without any camera
 *     where the policy estimates nothing
 * @param counts by camera and view, how many observations an estimate rests on, NaN if not known;
 *     as {@code estimates}
 * @param seeing by camera, the view through which it sees, -1 while it moves blindly; empty where
 *     no camera needs time for a move
 * @param belief what the first camera online believes, as {@link BeliefFrame} has it; empty where
 *     cameras believe nothing
 */
public record Frame(
    long step,
    boolean[] online,
    int[] level,
    int[] detected,
    boolean[] present,
    double[] x,
    double[] y,
    int[] coverage,
    double[][] estimates,
    double[][] counts,
    @JsonInclude(JsonInclude.Include.NON_EMPTY) int[] seeing,
    @JsonInclude(JsonInclude.Include.NON_EMPTY) double[] belief)
    implements CoveredTargets {
  /**
   * A frame to be filled.
   *
   * @param estimated whether it has room for estimates
   * @param believed whether it has room for what is believed
   */
  static Frame blank(Setup setup, long step, boolean estimated, boolean believed) {
    int cameras = setup.cameras().size();
    int targets = setup.targets().size();
    return new Frame(
        step,
        new boolean[cameras],
        new int[cameras],
        new int[cameras],
        new boolean[targets],
        new double[targets],
        new double[targets],
        new int[targets],
        byView(setup, estimated ? cameras : 0),
        byView(setup, estimated ? cameras : 0),
        new int[setup.slow().isEmpty() ? 0 : cameras],
        new double[believed ? BeliefFrame.length(setup) : 0]);
  }

  private static double[][] byView(Setup setup, int cameras) {
    double[][] values = new double[cameras][];
    for (int camera = 0; camera < cameras; camera++) {
      values[camera] = new double[setup.cameras().get(camera).pose().views()];
    }
    return values;
  }

  /** The same without what the agents know. */
  public Frame withoutEstimates() {
    double[][] none = {};
    double[] nothing = {};
    return new Frame(
        step, online, level, detected, present, x, y, coverage, none, none, seeing, nothing);
  }

  /** How the targets present are covered: k_min and the rest of a row of {@code steps.csv}. */
  public StepCoverage measure() {
    StepCoverage measured = new StepCoverage();
    measured.measure(this);
    return measured;
  }

  @Override
  public int targets() {
    return coverage.length;
  }

  @Override
  public boolean present(int target) {
    return present[target];
  }

  @Override
  public int coverage(int target) {
    return coverage[target];
  }
}
