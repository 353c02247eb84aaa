package org.hificamsim.tracks.format;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.List;
import org.hificamsim.core.file.Fields;

/**
 * Reads the column of a format that counts frames. Some files have dates, times of day or Unix
 * times in that column.
 */
final class Ticks {
  /** The number of rows that decide between times and frames; the first may be names and units. */
  private static final int FIRST_ROWS = 4;

  private static final double MILLISECONDS_PER_SECOND = 1000;

  private final boolean areTimes;
  private final Clock clock;
  private final boolean areMilliseconds;
  private final Times times = new Times();

  private Ticks(boolean areTimes, Clock clock, boolean areMilliseconds) {
    this.areTimes = areTimes;
    this.clock = clock;
    this.areMilliseconds = areMilliseconds;
  }

  /**
   * Returns a reader of a recording's ticks.
   *
   * @param column the column of ticks, from 0
   * @throws org.hificamsim.core.InputException if they are frames and their rate is not given
   */
  static Ticks of(Recording recording, int column) {
    List<LineFields> rows = recording.start().rows();
    List<LineFields> first = rows.subList(0, Math.min(FIRST_ROWS, rows.size()));
    if (first.stream().anyMatch(row -> isTime(row, column))) {
      return times(false);
    }
    if (recording.rate().isEmpty() && first.stream().anyMatch(row -> isFraction(row, column))) {
      throw recording.missing(
          setting("rate", "1")
              + " if column "
              + (column + 1)
              + " has seconds, as its numbers are not whole; else the frames per second");
    }
    return new Ticks(false, recording.frames(), false);
  }

  /**
   * Returns a reader of times.
   *
   * @param areMilliseconds whether numbers count milliseconds, not seconds
   */
  static Ticks times(boolean areMilliseconds) {
    return new Ticks(true, Clock.SECONDS, areMilliseconds);
  }

  private static boolean isFraction(Fields row, int column) {
    double number = column < row.count() ? row.value(column) : Double.NaN;
    return Double.isFinite(number) && number != Math.rint(number);
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
    double seconds = value(row, column);
    if (Double.isNaN(seconds)) {
      throw row.invalid(
          column, "time", column < row.count() ? times.expected(row.text(column)) : Times.EXPECTED);
    }
    return seconds;
  }

  /** Returns the frame or the seconds in a row, which has the column; NaN if it has neither. */
  double value(Fields row, int column) {
    if (!areTimes) {
      return row.value(column);
    }
    double seconds = times.seconds(row, column);
    boolean isScaled = areMilliseconds && column < row.count() && seconds == row.value(column);
    return isScaled ? seconds / MILLISECONDS_PER_SECOND : seconds;
  }
}
