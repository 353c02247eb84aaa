package org.hificamsim.tracks.format;

import java.time.DateTimeException;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.core.file.Fields;

/**
 * Reads the times of one file, by the same rules in every format: numbers of seconds; Unix times in
 * seconds, milliseconds, microseconds or nanoseconds; dates; ISO 8601 with a zone, or without one
 * as UTC; times of day, which go on after midnight; and minutes and seconds with a fraction. A file
 * has numbers, dates or times of day, not several of them.
 */
final class Times {
  /** The allowed times, for messages. */
  static final String EXPECTED =
      "a time: seconds, a Unix time, as 2024-05-31T12:00:00Z, or as 12:00:00";

  /** The least number of seconds that is a Unix time: a day in 1973. */
  static final double FIRST_UNIX_TIME = 1e8;

  /**
   * The greatest number of seconds. Greater numbers are milliseconds, those a thousand times
   * greater microseconds, and so on.
   */
  private static final double MAX_SECONDS = 1e11;

  private static final double DAY = 86_400;
  private static final double HOUR = 3600;
  private static final double MINUTE = 60;
  private static final int NOON = 12;

  private static final String SECOND = "(?<second>[0-6]\\d(?:[.,]\\d{1,12})?)";
  private static final String HALF_OF_DAY = "(?:\\s*(?<half>[AaPp])\\.?[Mm]\\.?)?";

  private static final Pattern TIME_OF_DAY =
      Pattern.compile(
          "(?:(?<days>\\d{1,6}):)?(?<hour>\\d{1,3}):(?<minute>[0-5]\\d):" + SECOND + HALF_OF_DAY);

  /** The start of a time without seconds that is before or after noon, such as 8:00 am. */
  private static final Pattern WITHOUT_SECONDS =
      Pattern.compile("^(\\d{1,2}:[0-5]\\d)(?=\\s*[AaPp]\\.?[Mm]\\.?$)");

  private static final Pattern MINUTES =
      Pattern.compile("(?<minutes>\\d{1,4}):(?<seconds>[0-5]\\d[.,]\\d{1,12})");

  private static final Pattern DATE =
      Pattern.compile(
          "(?:(?<year>\\d{4})(?<to>[-/.]?)(?<month>\\d\\d)\\k<to>(?<day>\\d\\d)"
              + "|(?<day2>\\d{1,2})\\.(?<month2>\\d{1,2})\\.(?<year2>\\d{4})"
              + "|(?<first>\\d{1,2})(?<by>[-/])(?<second2>\\d{1,2})\\k<by>(?<year3>\\d{4}|\\d\\d))"
              + "(?:[T\\s,_]+(?<hour>\\d{1,2})(?::?(?<minute>[0-5]\\d)(?::?"
              + SECOND
              + ")?)?"
              + HALF_OF_DAY
              + ")?(?:\\s*(?<zone>[Zz]|UTC|GMT|[+\\-]\\d\\d(?::?\\d\\d)?))?");

  private enum Notation {
    NUMBER,
    DATE,
    TIME_OF_DAY
  }

  private static final Pattern NUMERIC_DATE =
      Pattern.compile("\\d{1,2}([-/])\\d{1,2}\\1(\\d{4}|\\d\\d)\\b.*");
  private static final Pattern TWO_NUMBERS = Pattern.compile("\\d{1,2}:\\d\\d");

  private final NumericDates numericDates = new NumericDates();
  private Notation notation;
  private double lastOfDay;

  /** Returns the time in a field, in seconds; NaN if the field has none. */
  double seconds(Fields row, int field) {
    if (field >= row.count()) {
      return Double.NaN;
    }
    double number = row.value(field);
    return Double.isFinite(number) ? fromNumber(number) : fromText(row.text(field).strip());
  }

  /** Returns a time in seconds; NaN if the text has none. */
  double seconds(String text) {
    double number = Fields.value(text);
    return Double.isFinite(number) ? fromNumber(number) : fromText(text.strip());
  }

  private double fromNumber(double number) {
    double seconds = number;
    for (double limit = MAX_SECONDS; Math.abs(number) >= limit && limit < 1e18; limit *= 1e3) {
      seconds /= 1e3;
    }
    return Math.abs(seconds) < MAX_SECONDS ? checked(Notation.NUMBER, seconds) : Double.NaN;
  }

  private double fromText(String text) {
    Matcher date = DATE.matcher(text);
    if (date.matches()) {
      return checked(Notation.DATE, sinceEpoch(date));
    }
    Matcher minutes = MINUTES.matcher(text);
    if (minutes.matches()) {
      double seconds = Double.parseDouble(minutes.group("seconds").replace(',', '.'));
      return checked(Notation.TIME_OF_DAY, number(minutes, "minutes") * MINUTE + seconds);
    }
    Matcher time = TIME_OF_DAY.matcher(WITHOUT_SECONDS.matcher(text).replaceFirst("$1:00"));
    return time.matches() ? checked(Notation.TIME_OF_DAY, fromTimeOfDay(time)) : Double.NaN;
  }

  /** Describes the time that was expected in place of a text, for error messages. */
  String expected(String text) {
    String time = text.strip();
    if (TWO_NUMBERS.matcher(time).matches()) {
      return "00:%1$s if these are minutes and seconds, %1$s:00 if hours and minutes"
          .formatted(time);
    }
    if (Fields.isGrouped(time)) {
      return "a number without separators of thousands";
    }
    return NUMERIC_DATE.matcher(time).matches() && notation != Notation.NUMBER
        ? "a date such as 2024-05-31: the file does not tell months from days"
        : EXPECTED;
  }

  /** Returns the time, or NaN if the file has times in another notation. */
  private double checked(Notation found, double seconds) {
    notation = notation == null && !Double.isNaN(seconds) ? found : notation;
    return notation == found ? seconds : Double.NaN;
  }

  private double sinceEpoch(Matcher date) {
    try {
      return day(date).toEpochDay() * DAY + clock(date) - offset(date.group("zone"));
    } catch (DateTimeException e) {
      return Double.NaN;
    }
  }

  private LocalDate day(Matcher date) {
    if (date.group("first") != null) {
      return numericDates.day(
          number(date, "first"), number(date, "second2"), number(date, "year3"));
    }
    boolean yearFirst = date.group("year") != null;
    return LocalDate.of(
        number(date, yearFirst ? "year" : "year2"),
        number(date, yearFirst ? "month" : "month2"),
        number(date, yearFirst ? "day" : "day2"));
  }

  private static int offset(String zone) {
    boolean isNumber = zone != null && (zone.startsWith("+") || zone.startsWith("-"));
    return isNumber ? ZoneOffset.of(zone).getTotalSeconds() : 0;
  }

  /** Returns the time on the day that brings it nearest to the time read before. */
  private double fromTimeOfDay(Matcher time) {
    double seconds = number(time, "days") * DAY + clock(time);
    if (Double.isNaN(seconds)) {
      return seconds;
    }
    boolean isFirst = notation != Notation.TIME_OF_DAY;
    lastOfDay = isFirst ? seconds : seconds + DAY * Math.rint((lastOfDay - seconds) / DAY);
    return lastOfDay;
  }

  private static double clock(Matcher time) {
    int hour = number(time, "hour");
    String half = time.group("half");
    if (half != null && (hour < 1 || hour > NOON)) {
      return Double.NaN;
    }
    if (half != null) {
      hour = hour % NOON + (half.equalsIgnoreCase("p") ? NOON : 0);
    }
    String second = time.group("second");
    double seconds = second == null ? 0 : Double.parseDouble(second.replace(',', '.'));
    return hour * HOUR + number(time, "minute") * MINUTE + seconds;
  }

  private static int number(Matcher time, String group) {
    String digits = time.group(group);
    return digits == null ? 0 : Integer.parseInt(digits);
  }
}
