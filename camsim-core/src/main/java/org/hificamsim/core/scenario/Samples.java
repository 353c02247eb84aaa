package org.hificamsim.core.scenario;

import java.util.Arrays;

/** The samples of a track that is being read; filled again for each. */
final class Samples {
  private double[] samples = new double[3 * 64]; // time, x and y of each
  private int end;

  boolean isEmpty() {
    return end == 0;
  }

  /** When the last one was taken, seconds. */
  double last() {
    return samples[end - 3];
  }

  void add(double time, double x, double y) {
    if (end == samples.length) {
      samples = Arrays.copyOf(samples, 2 * end);
    }
    samples[end++] = time;
    samples[end++] = x;
    samples[end++] = y;
  }

  /** Ends the track; the next sample begins another. */
  Track track(double stepTime) {
    Track track = new Track(Arrays.copyOf(samples, end), stepTime);
    end = 0;
    return track;
  }
}
