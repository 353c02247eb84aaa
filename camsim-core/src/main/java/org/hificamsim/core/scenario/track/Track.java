package org.hificamsim.core.scenario.track;

import java.util.Arrays;
import java.util.function.UnaryOperator;
import org.hificamsim.core.obstacle.Point;

/**
 * The recorded path of a target from its first to its last sample, on the clock of a scenario's
 * steps. Between two samples the target moves straight.
 */
public final class Track {
  /** The time, in seconds, up to which a step counts as being at a sample in spite of rounding. */
  private static final double SLACK = 1e-6;

  /** Each sample has a time, an x and a y. */
  private static final int FIELDS = 3;

  private final double[] samples;
  private final double stepTime;
  private StepPlaces places;

  /**
   * Creates a track.
   *
   * @param samples for each sample the time in seconds from step 0, rising, and x and y in metres
   * @param stepTime the step time, in seconds, above 0
   */
  public Track(double[] samples, double stepTime) {
    this.samples = samples;
    this.stepTime = stepTime;
  }

  /** The number of samples, 1 or more. */
  public int samples() {
    return samples.length / FIELDS;
  }

  /** The time of a sample, in seconds from step 0. */
  public double time(int sample) {
    return samples[FIELDS * sample];
  }

  /** The x coordinate, in metres. */
  public double x(int sample) {
    return samples[FIELDS * sample + 1];
  }

  /** The y coordinate, in metres. */
  public double y(int sample) {
    return samples[FIELDS * sample + 2];
  }

  /** The duration of a step, in seconds. */
  public double stepTime() {
    return stepTime;
  }

  /** The first step at which the target is present. */
  public long firstStep() {
    return (long) Math.ceil((time(0) - SLACK) / stepTime);
  }

  /** The last step at which the target is present; below the first one if there is none. */
  public long lastStep() {
    return (long) Math.floor((time(samples() - 1) + SLACK) / stepTime);
  }

  /** Stores the precomputed positions, before the track is used. */
  void store(StepPlaces newPlaces) {
    places = newPlaces;
  }

  /** The precomputed positions; null if they are computed on the way. */
  StepPlaces places() {
    return places;
  }

  /**
   * Returns the rest of the track from a time on, with times from that time and moved positions.
   *
   * @param start the time from which the track is kept, in seconds, not after the last sample
   * @param moved maps each position to the new one
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
      Point position = moved.apply(new Point(rest[i + 1], rest[i + 2]));
      rest[i] = Math.max(0, rest[i] - start);
      rest[i + 1] = position.x();
      rest[i + 2] = position.y();
    }
    return new Track(rest, stepTime);
  }

  /** The mean speed along the way, metres a step. */
  public double meanSpeed() {
    double length = 0;
    for (int i = 1; i < samples(); i++) {
      length += Math.hypot(x(i) - x(i - 1), y(i) - y(i - 1));
    }
    return length == 0 ? 0 : length / (time(samples() - 1) - time(0)) * stepTime;
  }

  /** The heading from the first to the second sample, in degrees, 0 is +y and 90 is +x. */
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
