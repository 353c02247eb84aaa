package org.hificamsim.cli;

import java.util.Arrays;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;

/**
 * The mean score over all repeats in a few parts of the run, of equally many steps (some may have
 * one more than others).
 */
final class ScoreOverTime implements StepListener {
  private static final int MAX_PARTS = 40;

  private final int steps;
  private final double[] sums;
  private final long[] counts;

  /**
   * @param steps of every repeat, 1 or more
   */
  ScoreOverTime(int steps) {
    this.steps = steps;
    this.sums = new double[Math.min(steps, MAX_PARTS)];
    this.counts = new long[sums.length];
  }

  @Override
  public void stepped(NetworkView network, StepCoverage coverage) {
    int part = (int) (network.step() * sums.length / steps);
    sums[part] += coverage.score();
    counts[part]++;
  }

  /** The mean of each part; 0 where nothing ran. */
  double[] means() {
    double[] means = new double[sums.length];
    Arrays.setAll(means, part -> sums[part] / Math.max(1, counts[part]));
    return means;
  }
}
