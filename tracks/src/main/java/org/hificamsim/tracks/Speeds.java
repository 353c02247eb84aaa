package org.hificamsim.tracks;

/** How often each speed was, in steps of {@value #STEP} m/s, in bounded memory. */
final class Speeds {
  private static final double STEP = 0.01;
  private static final int BINS = 100_001; // up to 1,000 m/s; the last has the faster ones

  private final long[] counts = new long[BINS];
  private long count;

  void add(double metresPerSecond) {
    counts[(int) Math.min(BINS - 1, Math.rint(metresPerSecond / STEP))]++;
    count++;
  }

  /** The speed that this part of all is not above; NaN where there is none. */
  double quantile(double part) {
    long below = 0;
    for (int bin = 0; bin < BINS; bin++) {
      below += counts[bin];
      if (count > 0 && below >= part * count) {
        return bin * STEP;
      }
    }
    return Double.NaN;
  }

  /** How many were above a speed. */
  long above(double metresPerSecond) {
    long above = 0;
    for (int bin = BINS - 1; bin >= 0 && bin * STEP > metresPerSecond; bin--) {
      above += counts[bin];
    }
    return above;
  }
}
