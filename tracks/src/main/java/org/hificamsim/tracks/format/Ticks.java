package org.hificamsim.tracks.format;

import org.hificamsim.core.file.Fields;

/**
 * Reads the column of a format that counts frames. Some files have times there: dates, times of
 * day, or Unix times.
 */
final class Ticks {
  private final boolean areTimes;
  private final Clock clock;
  private final Times times = new Times();

  private Ticks(boolean areTimes, Clock clock) {
    this.areTimes = areTimes;
    this.clock = clock;
  }

  /**
   * Returns a reader of a recording's ticks.
   *
   * @param column in which the ticks are, from 0
   * @throws org.hificamsim.core.InputException if they are frames and their rate is not given
   */
  static Ticks of(Recording recording, int column) {
    boolean areTimes =
        recording.start().rows().stream().limit(1).anyMatch(row -> isTime(row, column));
    return areTimes ? times() : frames(recording);
  }

  /** Returns a reader of times. */
  static Ticks times() {
    return new Ticks(true, Clock.SECONDS);
  }

  /**
   * Returns a reader of frames.
   *
   * @throws org.hificamsim.core.InputException if their rate is not given
   */
  static Ticks frames(Recording recording) {
    return new Ticks(false, recording.frames());
  }

  private static boolean isTime(Fields row, int column) {
    double seconds = new Times().seconds(row, column);
    boolean isNumber = column < row.count() && Double.isFinite(row.value(column));
    return isNumber ? seconds >= Times.FIRST_UNIX_TIME : !Double.isNaN(seconds);
  }

  Clock clock() {
    return clock;
  }

  /**
   * Reads the frame or the seconds in a row.
   *
   * @throws org.hificamsim.core.InputException with the place, if it has neither
   */
  double tick(Fields row, int column) {
    if (!areTimes) {
      return row.number(column, "frame");
    }
    double seconds = times.seconds(row, column);
    if (Double.isNaN(seconds)) {
      throw row.invalid(column, "time", Times.EXPECTED);
    }
    return seconds;
  }
}
