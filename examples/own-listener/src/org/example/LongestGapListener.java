package org.example;

import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.OracleView;

/**
 * A listener of one's own that counts for how many steps in a row no camera covered some target.
 */
public final class LongestGapListener implements StepListener {
  private long gap;
  private long longest;

  @Override
  public String name() {
    return "longest-gap";
  }

  @Override
  public void stepped(OracleView network, StepCoverage coverage) {
    gap = coverage.kMin() == 0 ? gap + 1 : 0;
    longest = Math.max(longest, gap);
  }

  @Override
  public void ended(OracleView network) {
    System.out.println("longest gap in coverage: " + longest + " steps");
  }
}
