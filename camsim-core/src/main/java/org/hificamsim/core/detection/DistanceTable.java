package org.hificamsim.core.detection;

import java.util.function.DoubleUnaryOperator;

/**
 * A tabulated function of distance. The distances from 0 to a radius are divided into equal bins,
 * each with a cubic through four of its {@value #SAMPLES} + 1 samples. The number of bins is the
 * smallest for which no cubic misses a sample by more than {@value #TOLERANCE}, at most {@value
 * #MAX_BINS}; in bins whose cubic still misses one, the function itself is evaluated.
 */
public final class DistanceTable {
  static final int MAX_BINS = 512;
  static final int SAMPLES = 12;
  private static final int MIN_BINS = 32;
  private static final int TERMS = 4;
  private static final double TOLERANCE = 5e-9;

  private final DoubleUnaryOperator function;
  private final int bins;
  private final double binsPerMetre;
  private final double[] cubic;

  /** Receives the samples of each bin. */
  @FunctionalInterface
  interface SampleListener {
    /** Called with the {@value #SAMPLES} + 1 samples of a bin, from border to border. */
    void bin(int bin, double[] samples);
  }

  /**
   * Creates a table with as few bins as are accurate enough.
   *
   * @param radius the radius, in metres, above 0
   */
  public static DistanceTable of(double radius, DoubleUnaryOperator function) {
    int bins = MIN_BINS;
    DistanceTable table = new DistanceTable(radius, function, bins, (bin, samples) -> {});
    while (bins < MAX_BINS && !table.isComplete()) {
      bins *= 2;
      table = new DistanceTable(radius, function, bins, (bin, samples) -> {});
    }
    return table;
  }

  /**
   * Creates a table with {@value #MAX_BINS} bins.
   *
   * @param radius the radius, in metres, above 0
   * @param listener receives the samples of each bin
   */
  DistanceTable(double radius, DoubleUnaryOperator function, SampleListener listener) {
    this(radius, function, MAX_BINS, listener);
  }

  private DistanceTable(
      double radius, DoubleUnaryOperator function, int bins, SampleListener listener) {
    this.function = function;
    this.bins = bins;
    this.binsPerMetre = bins / radius;
    this.cubic = new double[bins * TERMS];
    double[] samples = new double[SAMPLES + 1];
    for (int bin = 0; bin < bins; bin++) {
      for (int i = 0; i <= SAMPLES; i++) {
        samples[i] = function.applyAsDouble(radius * ((bin + (double) i / SAMPLES) / bins));
      }
      listener.bin(bin, samples);
      interpolate(bin, samples);
    }
  }

  /** Whether no bin needs the function itself. */
  private boolean isComplete() {
    for (int bin = 0; bin < bins; bin++) {
      if (Double.isNaN(cubic[bin * TERMS])) {
        return false;
      }
    }
    return true;
  }

  /** Interpolates a bin by Newton's forward differences; NaN marks a cubic that is not close. */
  private void interpolate(int bin, double[] samples) {
    int third = SAMPLES / 3;
    double first = samples[third] - samples[0];
    double second = samples[2 * third] - samples[third];
    double last = samples[SAMPLES] - samples[2 * third];
    int offset = bin * TERMS;
    cubic[offset] = samples[0];
    cubic[offset + 1] = first;
    cubic[offset + 2] = (second - first) / 2;
    cubic[offset + 3] = (last - 2 * second + first) / 6;
    for (int i = 0; i <= SAMPLES; i++) {
      if (!(Math.abs(cubic(offset, 3.0 * i / SAMPLES) - samples[i]) <= TOLERANCE)) {
        cubic[offset] = Double.NaN;
        return;
      }
    }
  }

  /**
   * Evaluates the cubic of a bin.
   *
   * @param s the position in the bin, in thirds, [0, 3]
   */
  private double cubic(int offset, double s) {
    double sum = cubic[offset + 2] + (s - 2) * cubic[offset + 3];
    return cubic[offset] + s * (cubic[offset + 1] + (s - 1) * sum);
  }

  /** The bin of a distance in metres. */
  int bin(double distance) {
    return Math.min((int) (distance * binsPerMetre), bins - 1);
  }

  /** The function at a distance of at most the radius, in metres, to twice {@value #TOLERANCE}. */
  public double value(double distance) {
    int bin = bin(distance);
    double value = cubic(bin * TERMS, 3 * (distance * binsPerMetre - bin));
    return Double.isNaN(value) ? function.applyAsDouble(distance) : value;
  }
}
