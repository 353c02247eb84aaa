package org.hificamsim.cli;

import java.util.Arrays;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;

/**
 * The mean of k_min over all repeats in a few parts of the run, of equally many steps (some may
 * have one more than others). Repeats may run on several threads: the sums are of whole numbers.
 */
final class KMinOverTime {
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

  /** The listener of one repeat. */
  StepListener listener() {
    return new Repeat();
  }

  /** The mean of each part; 0 where nothing ran. */
  synchronized double[] means() {
    double[] means = new double[sums.length];
    Arrays.setAll(means, part -> sums[part] / (double) Math.max(1, counts[part]));
    return means;
  }

  private synchronized void add(long[] repeatSums, long[] repeatCounts) {
    for (int part = 0; part < sums.length; part++) {
      sums[part] += repeatSums[part];
      counts[part] += repeatCounts[part];
    }
  }

  private final class Repeat implements StepListener {
    private final long[] own = new long[sums.length];
    private final long[] seen = new long[sums.length];

    @Override
    public void stepped(NetworkView network, StepCoverage coverage) {
      int part = (int) (network.step() * own.length / steps);
      own[part] += coverage.kMin();
      seen[part]++;
    }

    @Override
    public void ended(NetworkView network) {
      add(own, seen);
    }
  }
}
