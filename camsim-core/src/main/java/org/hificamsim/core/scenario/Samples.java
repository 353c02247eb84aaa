package org.hificamsim.core.scenario;

import java.util.Arrays;

/** The samples of a track that is being read; filled again for each. */
final class Samples {
  private double[] times = new double[64];
  private double[] x = new double[64];
  private double[] y = new double[64];
  private int count;

  boolean isEmpty() {
    return count == 0;
  }

  /** When the last one was taken, seconds. */
  double last() {
    return times[count - 1];
  }

  void add(double time, double itsX, double itsY) {
    if (count == times.length) {
      times = Arrays.copyOf(times, 2 * count);
      x = Arrays.copyOf(x, 2 * count);
      y = Arrays.copyOf(y, 2 * count);
    }
    times[count] = time;
    x[count] = itsX;
    y[count++] = itsY;
  }

  /** Ends the track; the next sample begins another. */
  Track track(double stepTime) {
    Track track =
        new Track(
            Arrays.copyOf(times, count),
            Arrays.copyOf(x, count),
            Arrays.copyOf(y, count),
            stepTime);
    count = 0;
    return track;
  }
}
