package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;

/**
 * The coverage of a whole run, added up step by step (thesis 7.1, Eq 7.2; Figure 7.9), and how
 * often cameras changed their zoom for it.
 */
public final class RunCoverage implements StepListener {
  private long steps;
  private long performance;
  private long targets;
  private long uncovered;
  private long coveredOnce;
  private long coveredMore;
  private double sumOfMeans;
  private long detections;
  private long zoomChanges;
  private int[] levels = {};

  @Override
  public void stepped(NetworkView network, StepCoverage coverage) {
    steps++;
    performance += coverage.kMin();
    targets += coverage.targets();
    uncovered += coverage.covered0();
    coveredOnce += coverage.covered1();
    coveredMore += coverage.coveredK();
    sumOfMeans += coverage.meanK();
    detections += coverage.detections();
    countZoomChanges(network);
  }

  /** A camera's first level is no change; a network may grow. */
  private void countZoomChanges(NetworkView network) {
    int known = levels.length;
    if (network.cameras() > known) {
      levels = Arrays.copyOf(levels, network.cameras());
    }
    for (int camera = 0; camera < network.cameras(); camera++) {
      int level = network.level(camera);
      if (camera < known && level != levels[camera]) {
        zoomChanges++;
      }
      levels[camera] = level;
    }
  }

  /** The number of steps so far. */
  public long steps() {
    return steps;
  }

  /** The sum of k_min over the steps (Eq 7.2). */
  public long performance() {
    return performance;
  }

  /** The mean of k_min over the steps; 0 without steps. */
  public double meanKMin() {
    return steps == 0 ? 0 : (double) performance / steps;
  }

  /** The share of targets, over all steps, that no camera covered; 0 without targets. */
  public double proportion0() {
    return share(uncovered);
  }

  /** The share of targets that exactly one camera covered. */
  public double proportion1() {
    return share(coveredOnce);
  }

  /** The share of targets that two or more cameras covered. */
  public double proportionK() {
    return share(coveredMore);
  }

  /** The mean over the steps of the mean of k_j over the targets. */
  public double meanK() {
    return steps == 0 ? 0 : sumOfMeans / steps;
  }

  /** The number of detections: one for each camera, target and step. */
  public long detections() {
    return detections;
  }

  /** How often a camera's level differed from the one of the step before. */
  public long zoomChanges() {
    return zoomChanges;
  }

  private double share(long count) {
    return targets == 0 ? 0 : (double) count / targets;
  }
}
