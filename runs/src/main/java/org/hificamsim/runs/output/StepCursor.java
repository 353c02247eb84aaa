package org.hificamsim.runs.output;

import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.OracleView;

/**
 * The step, camera or target that a row of a run's tables is about: one object for all rows, so
 * that none is made for each.
 */
public final class StepCursor {
  int run;
  long step;
  StepCoverage coverage;
  OracleView network;
  int camera;
  int target;

  /** Moves to a step that the network is not needed of. */
  public StepCursor at(int newRun, long newStep, StepCoverage newCoverage) {
    run = newRun;
    step = newStep;
    coverage = newCoverage;
    return this;
  }
}
