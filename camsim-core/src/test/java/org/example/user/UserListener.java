package org.example.user;

import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.OracleView;

/** Sums k_min over the steps. */
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
