package org.hificamsim.core.detection;

import java.util.Arrays;
import java.util.function.DoublePredicate;

/**
 * The distances at which a detection model detects a target of one size at one zoom level: a set of
 * closed intervals of squared distance, exact to the last bit at each end.
 *
 * <p>Computed once for each level and size, so that observing compares squared distances. The model
 * is sampled at {@value #SAMPLES} distances between 0 and the radius, and each change between
 * detected and undetected is narrowed down to adjacent doubles. An interval that lies between two
 * samples is missed.
 */
public final class DetectedDistances {
  /** The number of equal steps of distance that are sampled. */
  static final int SAMPLES = 4096;

  /** The empty set. */
  public static final DetectedDistances NONE = new DetectedDistances(new double[0]);

  private final double[] ends;

  private DetectedDistances(double[] ends) {
    this.ends = ends;
  }

  /**
   * Computes the distances within the radius at which {@code model} reaches {@code threshold}.
   *
   * @throws IllegalArgumentException if the model depends on the bearing
   */
  public static DetectedDistances of(
      DetectionModel model, double size, ZoomLevel zoom, double threshold) {
    if (model.dependsOnBearing()) {
      throw new IllegalArgumentException(
          model.name() + " depends on the bearing: its detected distances are no set of intervals");
    }
    DoublePredicate detectsAtSquared =
        squared -> {
          double distance = Math.sqrt(squared);
          return distance <= zoom.radius()
              && model.confidence(size, distance, 0, zoom) >= threshold;
        };
    double[] ends = new double[4];
    int count = 0;
    double before = 0;
    boolean inside = detectsAtSquared.test(0);
    if (inside) {
      ends[count++] = 0;
    }
    for (int i = 1; i <= SAMPLES + 1; i++) {
      // The last sample lies beyond any radius, where nothing is detected: it closes the set.
      double distance = i > SAMPLES ? Double.POSITIVE_INFINITY : zoom.radius() * i / SAMPLES;
      double squared = distance * distance;
      if (detectsAtSquared.test(squared) != inside) {
        ends = count == ends.length ? Arrays.copyOf(ends, 2 * count) : ends;
        ends[count++] = lastOrFirstDetected(detectsAtSquared, before, squared, inside);
        inside = !inside;
      }
      before = squared;
    }
    return count == 0 ? NONE : new DetectedDistances(Arrays.copyOf(ends, count));
  }

  /** Whether a target at this squared distance (square metres) is detected. */
  public boolean contains(double squaredDistance) {
    for (int i = 0; i < ends.length; i += 2) {
      if (squaredDistance >= ends[i] && squaredDistance <= ends[i + 1]) {
        return true;
      }
    }
    return false;
  }

  /** Whether every distance of {@code other} is detected here too. */
  public boolean includes(DetectedDistances other) {
    for (int i = 0; i < other.ends.length; i += 2) {
      if (!holds(other.ends[i], other.ends[i + 1])) {
        return false;
      }
    }
    return true;
  }

  /** The number of intervals. */
  public int intervals() {
    return ends.length / 2;
  }

  /** The squared distance at which interval {@code i} starts. */
  public double from(int i) {
    return ends[2 * i];
  }

  /** The squared distance at which interval {@code i} ends, itself detected. */
  public double to(int i) {
    return ends[2 * i + 1];
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof DetectedDistances that && Arrays.equals(ends, that.ends);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(ends);
  }

  @Override
  public String toString() {
    return "squared distances " + Arrays.toString(ends);
  }

  private boolean holds(double from, double to) {
    for (int i = 0; i < ends.length; i += 2) {
      if (ends[i] <= from && ends[i + 1] >= to) {
        return true;
      }
    }
    return false;
  }

  /** Bisects the bit patterns of two non-negative doubles of which one is detected. */
  private static double lastOrFirstDetected(
      DoublePredicate detectsAtSquared, double from, double to, boolean fromDetected) {
    long low = Double.doubleToLongBits(from);
    long high = Double.doubleToLongBits(to);
    while (high - low > 1) {
      long middle = low + (high - low) / 2;
      if (detectsAtSquared.test(Double.longBitsToDouble(middle)) == fromDetected) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return Double.longBitsToDouble(fromDetected ? low : high);
  }
}
