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
  private int[] who = {};
  private double[] chances = {};
  private int[] targetOf = new int[16]; // of each pair of a camera and a target
  private double[] chanceOf = new double[16];
  private double[] sorted = new double[16]; // the chances, by target
  private int[] ends = {}; // of each target's
  private double[] exactly = {}; // the chance that as many cameras cover the target under way
  private double[] atLeast = {};
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
    begin(observed);
    collect(observed);
    for (int target = 0; target < observed.targets(); target++) {
      if (observed.present(target)) {
        add(target);
      }
    }
  }

  private void begin(DetectionChances observed) {
    if (once.length < observed.targets() || allAtLeast.length <= observed.cameras()) {
      who = new int[observed.targets()];
      chances = new double[observed.targets()];
      ends = new int[observed.targets() + 1];
      once = new double[observed.targets()];
      more = new double[observed.targets()];
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
    leastOnce = Double.POSITIVE_INFINITY;
  }

  private void collect(DetectionChances observed) {
    int count = 0;
    for (int camera = 0; camera < observed.cameras(); camera++) {
      int some = observed.chances(camera, who, chances);
      if (count + some > targetOf.length) {
        targetOf = Arrays.copyOf(targetOf, 2 * (count + some));
        chanceOf = Arrays.copyOf(chanceOf, 2 * (count + some));
        sorted = new double[2 * (count + some)];
      }
      System.arraycopy(who, 0, targetOf, count, some);
      System.arraycopy(chances, 0, chanceOf, count, some);
      count += some;
    }
    sort(count);
  }

  /** A counting sort; a target's entry in {@code ends} rises from its first pair to its end. */
  private void sort(int count) {
    Arrays.fill(ends, 0);
    for (int i = 0; i < count; i++) {
      ends[targetOf[i] + 1]++;
    }
    for (int target = 1; target < ends.length; target++) {
      ends[target] += ends[target - 1];
    }
    for (int i = 0; i < count; i++) {
      sorted[ends[targetOf[i]]++] = chanceOf[i];
    }
  }

  private void add(int target) {
    int from = target == 0 ? 0 : ends[target - 1];
    mostCameras = Math.min(mostCameras, ends[target] - from);
    double mean = cover(from, ends[target], Math.max(mostCameras, 2));
    for (int k = 1; k <= mostCameras; k++) {
      allAtLeast[k] *= atLeast[k];
    }
    once[target] = atLeast[1];
    more[target] = atLeast[2];
    targets++;
    uncovered += 1 - once[target];
    coveredMore += more[target];
    sum += mean;
    leastMean = Math.min(leastMean, mean);
    leastOnce = Math.min(leastOnce, once[target]);
  }

  /**
   * How many cameras cover a target, by the chances from one index up to another.
   *
   * @param counted exactly; the last count is of as many or more, and gains from the one before
   * @return the expected number
   */
  private double cover(int from, int to, int counted) {
    int most = Math.min(counted, to - from);
    Arrays.fill(exactly, 0, counted + 1, 0);
    exactly[0] = 1;
    double mean = 0;
    for (int i = from; i < to; i++) {
      double chance = sorted[i];
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
