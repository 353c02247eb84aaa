package org.hificamsim.core.detection;

import java.util.function.DoubleUnaryOperator;

/**
 * A function of the distance, tabulated: the distances from 0 to a radius are cut into {@value
 * #BINS} equal bins, each with a cubic through four of its {@value #SAMPLES} samples and one more.
 * Where a cubic misses one of the others by more than {@value #TOLERANCE}, the function itself is
 * asked.
 */
public final class DistanceTable {
  static final int BINS = 512;
  static final int SAMPLES = 12;
  private static final int TERMS = 4;
  private static final double TOLERANCE = 5e-9;

  private final DoubleUnaryOperator inFull;
  private final double binsPerMetre;
  private final double[] cubic = new double[BINS * TERMS];

  /** Looks at the samples of a bin. */
  @FunctionalInterface
  interface Sampled {
    /** One more than {@value #SAMPLES} of them, from border to border. */
    void bin(int bin, double[] samples);
  }

  /**
   * Asks the function for all samples.
   *
   * @param radius metres, above 0
   * @param sampled is shown the samples, bin by bin
   */
  DistanceTable(double radius, DoubleUnaryOperator inFull, Sampled sampled) {
    this.inFull = inFull;
    this.binsPerMetre = BINS / radius;
    double[] samples = new double[SAMPLES + 1];
    for (int bin = 0; bin < BINS; bin++) {
      for (int i = 0; i <= SAMPLES; i++) {
        samples[i] = inFull.applyAsDouble(radius * ((bin + (double) i / SAMPLES) / BINS));
      }
      sampled.bin(bin, samples);
      interpolate(bin, samples);
    }
  }

  /** Newton's forward differences over thirds of the bin; NaN where the cubic is not close. */
  private void interpolate(int bin, double[] samples) {
    int third = SAMPLES / 3;
    double first = samples[third] - samples[0];
    double second = samples[2 * third] - samples[third];
    double last = samples[SAMPLES] - samples[2 * third];
    int at = bin * TERMS;
    cubic[at] = samples[0];
    cubic[at + 1] = first;
    cubic[at + 2] = (second - first) / 2;
    cubic[at + 3] = (last - 2 * second + first) / 6;
    for (int i = 0; i <= SAMPLES; i++) {
      if (!(Math.abs(cubic(at, 3.0 * i / SAMPLES) - samples[i]) <= TOLERANCE)) {
        cubic[at] = Double.NaN;
        return;
      }
    }
  }

  /**
   * The cubic of a bin.
   *
   * @param s thirds of the bin, [0, 3]
   */
  private double cubic(int at, double s) {
    double sum = cubic[at + 2] + (s - 2) * cubic[at + 3];
    return cubic[at] + s * (cubic[at + 1] + (s - 1) * sum);
  }

  /** The bin that a distance is in, metres. */
  int bin(double distance) {
    return Math.min((int) (distance * binsPerMetre), BINS - 1);
  }

  /** The function at a distance, metres, within the radius; to about twice {@value #TOLERANCE}. */
  public double value(double distance) {
    int bin = bin(distance);
    double value = cubic(bin * TERMS, 3 * (distance * binsPerMetre - bin));
    return Double.isNaN(value) ? inFull.applyAsDouble(distance) : value;
  }
}
