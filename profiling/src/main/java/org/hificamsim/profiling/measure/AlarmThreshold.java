package org.hificamsim.profiling.measure;

import java.util.Arrays;
import java.util.List;

/**
 * The least confidence that counts as a detection, such that photos without the object are rarely
 * taken for it.
 *
 * @param threshold half-way between what is allowed to be wrong and the next confidence of a photo
 *     with the object
 * @param falseAlarms the share of the photos without the object that is at or above it
 * @param recall the share of the photos with the object that is at or above it
 */
record AlarmThreshold(double threshold, double falseAlarms, double recall) {
  /**
   * The threshold.
   *
   * @param without confidences in photos without the object; one at least
   * @param with confidences in photos with it
   * @param rate of false alarms that is allowed at most, [0, 1)
   */
  static AlarmThreshold of(List<Double> without, List<Double> with, double rate) {
    double[] sorted = without.stream().mapToDouble(v -> v).sorted().toArray();
    double highest = sorted[sorted.length - 1 - (int) (rate * sorted.length)];
    double next =
        with.stream().mapToDouble(v -> v).filter(v -> v > highest).min().orElse(Double.NaN);
    double threshold = Double.isNaN(next) ? Math.nextUp(highest) : (highest + next) / 2;
    return new AlarmThreshold(
        threshold,
        Arrays.stream(sorted).filter(v -> v >= threshold).count() / (double) sorted.length,
        with.stream().filter(v -> v >= threshold).count() / (double) with.size());
  }
}
