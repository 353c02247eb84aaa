package org.hificamsim.presentation.replay;

import com.fasterxml.jackson.annotation.JsonInclude;
import org.hificamsim.core.metrics.CoveredTargets;
import org.hificamsim.core.metrics.StepCoverage;

/**
 * A copy of the state after one step. Arrays are indexed by the numbers of cameras and targets in
 * the {@link Setup}; the values of a camera that is not online, or of a target that is not present,
 * are undefined.
 *
 * @param level for each camera, the view that it chose last, which is its zoom level if it cannot
 *     turn, 0 for the narrowest
 * @param detected for each camera, the number of targets that it detects
 * @param x for each target, its x when the cameras observed it, in metres
 * @param y for each target, its y then, in metres
 * @param coverage for each target, the number of cameras that detect it, which is k_j of thesis 7.1
 * @param estimates for each camera and view, what the agent estimates, NaN if it has no estimate;
 *     of length 0 if the policy estimates nothing
 * @param counts for each camera and view, the number of observations of an estimate, NaN if not
 *     known; of the same length as {@code estimates}
 * @param seeing for each camera, the view that it has, -1 while it turns and sees nothing; empty if
 *     no camera needs time to turn
 * @param belief what the first camera online believes, as numbers of {@link BeliefFrame}; empty if
 *     cameras believe nothing
 * @param holders for each target, the camera that has it, -1 for none; empty unless the setup
 *     follows targets
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
    @JsonInclude(JsonInclude.Include.NON_EMPTY) double[] belief,
    @JsonInclude(JsonInclude.Include.NON_EMPTY) int[] holders)
    implements CoveredTargets {
  /**
   * Returns a frame of zeros.
   *
   * @param hasEstimates whether the frame holds estimates
   * @param hasBelief whether the frame holds a belief
   */
  static Frame blank(Setup setup, long step, boolean hasEstimates, boolean hasBelief) {
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
        byView(setup, hasEstimates ? cameras : 0),
        byView(setup, hasEstimates ? cameras : 0),
        new int[setup.slow().isEmpty() ? 0 : cameras],
        new double[hasBelief ? BeliefFrame.length(setup) : 0],
        new int[setup.following() ? targets : 0]);
  }

  private static double[][] byView(Setup setup, int cameras) {
    double[][] values = new double[cameras][];
    for (int camera = 0; camera < cameras; camera++) {
      values[camera] = new double[setup.cameras().get(camera).pose().views()];
    }
    return values;
  }

  /** Returns this frame without estimates and beliefs. */
  public Frame withoutEstimates() {
    double[][] noEstimates = {};
    double[] noBelief = {};
    return new Frame(
        step,
        online,
        level,
        detected,
        present,
        x,
        y,
        coverage,
        noEstimates,
        noEstimates,
        seeing,
        noBelief,
        holders);
  }

  /** Returns the coverage of the step, as in a row of {@code steps.csv}. */
  public StepCoverage measure() {
    StepCoverage coverage = new StepCoverage();
    coverage.measure(this);
    return coverage;
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
