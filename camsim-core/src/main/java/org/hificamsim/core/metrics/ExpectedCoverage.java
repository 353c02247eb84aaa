package org.hificamsim.core.metrics;

import java.util.Arrays;

/**
 * The expected coverage of the targets in one step, before luck is drawn. Detections are
 * independent, so the number of cameras that cover a target has a Poisson binomial distribution.
 *
 * <p>All values are 0 if no target is present.
 */
public final class ExpectedCoverage {
  private int[] targetsOfCamera = {};
  private double[] chancesOfCamera = {};
  private int[] targetOfPair = new int[16];
  private double[] chanceOfPair = new double[16];
  private double[] chancesByTarget = new double[16];

  /** The end of each target's chances in {@link #chancesByTarget}. */
  private int[] ends = {};

  /** The chance that exactly this number of cameras covers the current target, by number. */
  private double[] exactly = {};

  /** The chance that at least this number of cameras covers the current target, by number. */
  private double[] atLeast = {};

  /** The chance that at least this number of cameras covers each target, by number. */
  private double[] allAtLeast = {};

  private double[] chanceOfOne = {};
  private double[] chanceOfMore = {};
  private int targets;
  private int mostCameras;
  private double uncovered;
  private double coveredMore;
  private double sum;
  private double leastMean;
  private double leastChance;

  /** Measures the network in its current state. */
  void measure(DetectionChances observed) {
    begin(observed);
    collect(observed);
    for (int target = 0; target < observed.targets(); target++) {
      if (observed.present(target)) {
        add(target);
      }
    }
  }

  private void begin(DetectionChances observed) {
    if (chanceOfOne.length < observed.targets() || allAtLeast.length <= observed.cameras()) {
      targetsOfCamera = new int[observed.targets()];
      chancesOfCamera = new double[observed.targets()];
      ends = new int[observed.targets() + 1];
      chanceOfOne = new double[observed.targets()];
      chanceOfMore = new double[observed.targets()];
      allAtLeast = new double[observed.cameras() + 1];
      exactly = new double[observed.cameras() + 3];
      atLeast = new double[observed.cameras() + 4];
    }
    mostCameras = observed.cameras();
    Arrays.fill(allAtLeast, 1);
    targets = 0;
    uncovered = 0;
    coveredMore = 0;
    sum = 0;
    leastMean = Double.POSITIVE_INFINITY;
    leastChance = Double.POSITIVE_INFINITY;
  }

  private void collect(DetectionChances observed) {
    int count = 0;
    for (int camera = 0; camera < observed.cameras(); camera++) {
      int added = observed.chances(camera, targetsOfCamera, chancesOfCamera);
      if (count + added > targetOfPair.length) {
        targetOfPair = Arrays.copyOf(targetOfPair, 2 * (count + added));
        chanceOfPair = Arrays.copyOf(chanceOfPair, 2 * (count + added));
        chancesByTarget = new double[2 * (count + added)];
      }
      System.arraycopy(targetsOfCamera, 0, targetOfPair, count, added);
      System.arraycopy(chancesOfCamera, 0, chanceOfPair, count, added);
      count += added;
    }
    sort(count);
  }

  /** Sorts the chances by target: a counting sort. */
  private void sort(int count) {
    Arrays.fill(ends, 0);
    for (int i = 0; i < count; i++) {
      ends[targetOfPair[i] + 1]++;
    }
    for (int target = 1; target < ends.length; target++) {
      ends[target] += ends[target - 1];
    }
    for (int i = 0; i < count; i++) {
      chancesByTarget[ends[targetOfPair[i]]++] = chanceOfPair[i];
    }
  }

  private void add(int target) {
    int from = target == 0 ? 0 : ends[target - 1];
    mostCameras = Math.min(mostCameras, ends[target] - from);
    double mean = cover(from, ends[target], Math.max(mostCameras, 2));
    for (int k = 1; k <= mostCameras; k++) {
      allAtLeast[k] *= atLeast[k];
    }
    chanceOfOne[target] = atLeast[1];
    chanceOfMore[target] = atLeast[2];
    targets++;
    uncovered += 1 - chanceOfOne[target];
    coveredMore += chanceOfMore[target];
    sum += mean;
    leastMean = Math.min(leastMean, mean);
    leastChance = Math.min(leastChance, chanceOfOne[target]);
  }

  /**
   * Computes the distribution of the number of cameras that cover a target, from its chances.
   *
   * @param counted the greatest number that is counted; it stands for as many or more
   * @return the expected number
   */
  private double cover(int from, int to, int counted) {
    int most = Math.min(counted, to - from);
    Arrays.fill(exactly, 0, counted + 1, 0);
    exactly[0] = 1;
    double mean = 0;
    for (int i = from; i < to; i++) {
      double chance = chancesByTarget[i];
      mean += chance;
      exactly[most] += exactly[most - 1] * chance;
      for (int k = most - 1; k > 0; k--) {
        exactly[k] = exactly[k] * (1 - chance) + exactly[k - 1] * chance;
      }
      exactly[0] *= 1 - chance;
    }
    atLeast[counted + 1] = 0;
    for (int k = counted; k >= 0; k--) {
      atLeast[k] = Math.min(1, atLeast[k + 1] + exactly[k]);
    }
    return mean;
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
    return targets == 0 ? 0 : leastChance;
  }

  /** The chance that at least one camera covers a target, which must be present. */
  public double chanceOfOne(int target) {
    return chanceOfOne[target];
  }

  /** The chance that at least two cameras cover a target, which must be present. */
  public double chanceOfMore(int target) {
    return chanceOfMore[target];
  }
}
