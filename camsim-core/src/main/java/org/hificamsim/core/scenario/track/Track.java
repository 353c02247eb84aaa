package org.hificamsim.core.scenario.track;

import java.util.Arrays;
import java.util.function.UnaryOperator;
import org.hificamsim.core.obstacle.Point;

/**
 * Where a target was from when it came to when it went: samples in order of time, as a recording
 * has them, on the clock of a scenario's steps. Between two samples it went straight on.
 */
public final class Track {
  /** Seconds a step may be off a sample and still count as at it: rounding, no time. */
  private static final double SLACK = 1e-6;

  private static final int FIELDS = 3; // time, x and y of a sample lie side by side

  private final double[] samples;
  private final double stepTime;
  private StepPlaces places;

  /**
   * @param samples seconds from step 0, rising, x and y in metres, of each
   * @param stepTime seconds, above 0
   */
  public Track(double[] samples, double stepTime) {
    this.samples = samples;
    this.stepTime = stepTime;
  }

  /** The number of samples, 1 or more. */
  public int samples() {
    return samples.length / FIELDS;
  }

  /** When a sample was taken, seconds from step 0. */
  public double time(int sample) {
    return samples[FIELDS * sample];
  }

  /** Metres. */
  public double x(int sample) {
    return samples[FIELDS * sample + 1];
  }

  /** Metres. */
  public double y(int sample) {
    return samples[FIELDS * sample + 2];
  }

  /** How long a step takes, seconds. */
  public double stepTime() {
    return stepTime;
  }

  /** The first step at which the target is there. */
  public long firstStep() {
    return (long) Math.ceil((time(0) - SLACK) / stepTime);
  }

  /** The last step at which the target is there; before the first one where no step meets it. */
  public long lastStep() {
    return (long) Math.floor((time(samples() - 1) + SLACK) / stepTime);
  }

  /** Keeps where it is at each step, before anybody else knows the track. */
  void keep(StepPlaces itsPlaces) {
    places = itsPlaces;
  }

  /** Where it is at each step; null where that is worked out on the way. */
  StepPlaces places() {
    return places;
  }

  /**
   * The same from a time on, by a clock that begins then, at other places.
   *
   * @param start seconds, at or before the last sample
   */
  public Track from(double start, UnaryOperator<Point> moved) {
    int first = 0;
    while (first + 1 < samples() && time(first + 1) <= start) {
      first++;
    }
    double[] rest = Arrays.copyOfRange(samples, FIELDS * first, samples.length);
    if (time(first) < start && first + 1 < samples()) {
      double part = (start - time(first)) / (time(first + 1) - time(first));
      for (int i = 0; i < FIELDS; i++) {
        rest[i] += part * (rest[FIELDS + i] - rest[i]);
      }
    }
    for (int i = 0; i < rest.length; i += FIELDS) {
      Point place = moved.apply(new Point(rest[i + 1], rest[i + 2]));
      rest[i] = Math.max(0, rest[i] - start);
      rest[i + 1] = place.x();
      rest[i + 2] = place.y();
    }
    return new Track(rest, stepTime);
  }

  /** The speed from the first sample to the last along the way, metres a step. */
  public double meanSpeed() {
    double way = 0;
    for (int i = 1; i < samples(); i++) {
      way += Math.hypot(x(i) - x(i - 1), y(i) - y(i - 1));
    }
    return way == 0 ? 0 : way / (time(samples() - 1) - time(0)) * stepTime;
  }

  /** Which way it goes at first, degrees, 0 is +y and 90 is +x. */
  public double heading() {
    return samples() == 1 ? 0 : Math.toDegrees(Math.atan2(x(1) - x(0), y(1) - y(0)));
  }

  @Override
  public boolean equals(Object other) {
    return this == other
        || (other instanceof Track track
            && stepTime == track.stepTime
            && Arrays.equals(samples, track.samples));
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(samples);
  }

  @Override
  public String toString() {
    return samples() + " samples from " + time(0) + " s";
  }
}
