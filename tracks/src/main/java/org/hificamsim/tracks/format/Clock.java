package org.hificamsim.tracks.format;

import java.time.OffsetDateTime;

/**
 * The unit of time of a format.
 *
 * @param rate ticks per second, above 0
 * @param countsSamples whether the rate is the number of a target's samples per second, whatever
 *     the number of ticks between them
 */
public record Clock(double rate, boolean countsSamples) {
  /** Ticks are seconds. */
  public static final Clock SECONDS = new Clock(1, false);

  /**
   * Returns the seconds since 1970 of a time in ISO 8601.
   *
   * @throws java.time.DateTimeException if the text is not such a time with a zone
   */
  static double sinceEpoch(String text) {
    OffsetDateTime time = OffsetDateTime.parse(text);
    return time.toEpochSecond() + time.getNano() / 1e9;
  }

  /**
   * Returns the length of a tick in seconds.
   *
   * @param spacing the number of ticks between samples of a target
   */
  public double secondsPerTick(double spacing) {
    return countsSamples ? 1 / (rate * spacing) : 1 / rate;
  }
}
