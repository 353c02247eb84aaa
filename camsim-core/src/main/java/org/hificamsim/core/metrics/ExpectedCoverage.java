package org.hificamsim.core.metrics;

import java.util.Arrays;

/**
 * How the targets present are covered in one step as expected, before luck is drawn: as exact as
 * the chances are, and without the noise of a draw. Detections are independent, so the number of
 * cameras that cover a target has a Poisson binomial distribution.
 *
 * <p>Without any target everything is 0.
 */
public final class ExpectedCoverage {
  private final PoissonBinomial covering = new PoissonBinomial();
  private final PairsByTarget pairs = new PairsByTarget();
  private double[] allAtLeast = {};
  private double[] once = {};
  private double[] more = {};
  private int targets;
  private int mostCameras;
  private double uncovered;
  private double coveredMore;
  private double sum;
  private double leastMean;
  private double leastOnce;

  /** Measures the network as it is. */
  void measure(DetectionChances observed) {
    pairs.collect(observed);
    begin(observed);
    for (int target = 0; target < observed.targets(); target++) {
      if (observed.present(target)) {
        mostCameras = Math.min(mostCameras, pairs.count(target));
        pairs.cover(target, Math.max(mostCameras, 2), covering);
        add(target, pairs.mean(target));
      }
    }
  }

  private void begin(DetectionChances observed) {
    if (once.length < observed.targets() || allAtLeast.length <= observed.cameras()) {
      once = new double[observed.targets()];
      more = new double[observed.targets()];
      allAtLeast = new double[observed.cameras() + 1];
    }
    mostCameras = observed.cameras();
    Arrays.fill(allAtLeast, 1);
    targets = 0;
    uncovered = 0;
    coveredMore = 0;
    sum = 0;
    leastMean = Double.POSITIVE_INFINITY;
    leastOnce = Double.POSITIVE_INFINITY;
  }

  private void add(int target, double mean) {
    for (int k = 1; k <= mostCameras; k++) {
      allAtLeast[k] *= covering.atLeast(k);
    }
    once[target] = covering.atLeast(1);
    more[target] = covering.atLeast(2);
    targets++;
    uncovered += 1 - once[target];
    coveredMore += more[target];
    sum += mean;
    leastMean = Math.min(leastMean, mean);
    leastOnce = Math.min(leastOnce, once[target]);
  }

  /** The expected k_min: the sum over k of the chance that each target is covered k times. */
  public double kMin() {
    double expected = 0;
    for (int k = 1; k <= mostCameras && targets > 0; k++) {
      expected += allAtLeast[k];
    }
    return expected;
  }

  /** The expected number of targets that no camera covers. */
  public double covered0() {
    return uncovered;
  }

  /** The expected number of targets that exactly one camera covers. */
  public double covered1() {
    return Math.max(0, targets - uncovered - coveredMore);
  }

  /** The expected number of targets that two or more cameras cover. */
  public double coveredK() {
    return coveredMore;
  }

  /** The mean over the targets of the expected number of cameras that cover them. */
  public double meanK() {
    return targets == 0 ? 0 : sum / targets;
  }

  /** The least expected number of cameras that cover a target. */
  public double leastK() {
    return targets == 0 ? 0 : leastMean;
  }

  /** The least chance of a target to be covered at all. */
  public double leastChance() {
    return targets == 0 ? 0 : leastOnce;
  }

  /** The chance that one camera or more covers the target; of one that is present. */
  public double chanceOfOne(int target) {
    return once[target];
  }

  /** The chance that two cameras or more cover the target; of one that is present. */
  public double chanceOfMore(int target) {
    return more[target];
  }
}
