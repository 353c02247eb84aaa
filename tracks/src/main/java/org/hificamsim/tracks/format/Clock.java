package org.hificamsim.tracks.format;

import java.time.OffsetDateTime;

/**
 * How a format counts time.
 *
 * @param rate ticks a second, above 0
 * @param ofSamples whether the rate counts a target's samples, however many ticks lie between two
 */
public record Clock(double rate, boolean ofSamples) {
  /** Ticks are seconds. */
  public static final Clock SECONDS = new Clock(1, false);

  /**
   * Seconds since 1970 of a time as ISO 8601 writes it.
   *
   * @throws java.time.DateTimeException when it is no such time with its zone
   */
  static double sinceEpoch(String written) {
    OffsetDateTime time = OffsetDateTime.parse(written);
    return time.toEpochSecond() + time.getNano() / 1e9;
  }

  /** How long a tick is, seconds, where a target's samples are this many ticks apart. */
  public double secondsPerTick(double spacing) {
    return ofSamples ? 1 / (rate * spacing) : 1 / rate;
  }
}
