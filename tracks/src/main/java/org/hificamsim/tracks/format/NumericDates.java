package org.hificamsim.tracks.format;

import java.time.DateTimeException;
import java.time.LocalDate;

/**
 * Reads the dates of one file that look like 5/31/2024. A number above 12 decides whether the month
 * or the day comes first. It need not be decided if the file has a single date.
 */
final class NumericDates {
  private enum Order {
    MONTH_FIRST,
    DAY_FIRST
  }

  private static final int MONTHS = 12;
  private static final int THIS_CENTURY = 2000;

  private Order order; // null until a date decides it
  private LocalDate last; // null before the first date

  /**
   * Returns a day.
   *
   * @param year the year, or its last two digits
   * @throws DateTimeException if there is no such day, or if the order of month and day matters and
   *     is unknown
   */
  LocalDate day(int first, int second, int year) {
    int fullYear = year < 100 ? THIS_CENTURY + year : year;
    Order known = first > MONTHS ? Order.DAY_FIRST : second > MONTHS ? Order.MONTH_FIRST : order;
    LocalDate day =
        known == Order.DAY_FIRST
            ? LocalDate.of(fullYear, second, first)
            : LocalDate.of(fullYear, first, second);
    boolean isGuessed = order == null && last != null; // the last date, with the month first
    if (isGuessed && known != Order.MONTH_FIRST && !day.equals(last)) {
      throw new DateTimeException("the order of month and day is unknown");
    }
    if (order != null && known != order) {
      throw new DateTimeException("month and day change places");
    }
    order = known;
    last = day;
    return day;
  }
}
