package org.hificamsim.runs.output;

import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.OracleView;

/**
 * Points to the step, camera or target of a row of a run's tables. One object serves all rows, so
 * that a step allocates nothing.
 */
public final class StepCursor {
  int run;
  long step;
  StepCoverage coverage;
  OracleView network;
  int camera;
  int target;

  /** Moves to a step, without a network. */
  public StepCursor moveTo(int newRun, long newStep, StepCoverage newCoverage) {
    run = newRun;
    step = newStep;
    coverage = newCoverage;
    return this;
  }
}
