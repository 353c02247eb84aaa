package org.hificamsim.cli;

import java.util.Arrays;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;

/**
 * The mean of k_min over all repeats in a few parts of the run, of equally many steps (some may
 * have one more than others).
 */
final class KMinOverTime implements StepListener {
  private static final int MAX_PARTS = 40;

  private final int steps;
  private final long[] sums;
  private final long[] counts;

  /**
   * @param steps of every repeat, 1 or more
   */
  KMinOverTime(int steps) {
    this.steps = steps;
    this.sums = new long[Math.min(steps, MAX_PARTS)];
    this.counts = new long[sums.length];
  }

  @Override
  public void stepped(NetworkView network, StepCoverage coverage) {
    int part = (int) (network.step() * sums.length / steps);
    sums[part] += coverage.kMin();
    counts[part]++;
  }

  /** The mean of each part; 0 where nothing ran. */
  double[] means() {
    double[] means = new double[sums.length];
    Arrays.setAll(means, part -> sums[part] / (double) Math.max(1, counts[part]));
    return means;
  }
}
