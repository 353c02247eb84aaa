package org.example.user;

import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.OracleView;

/** Adds up k_min. */
public final class UserListener implements StepListener {
  private int sum;

  @Override
  public void stepped(OracleView network, StepCoverage coverage) {
    sum += coverage.kMin();
  }

  public int sum() {
    return sum;
  }
}
