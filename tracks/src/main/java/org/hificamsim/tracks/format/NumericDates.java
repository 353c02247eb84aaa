package org.hificamsim.tracks.format;

import java.time.DateTimeException;
import java.time.LocalDate;

/**
 * Dates such as 5/31/2024 of one file. A number above 12 tells whether the month or the day is
 * first. A file with a single date, whose year, month and day do not matter, needs none.
 */
final class NumericDates {
  private enum Order {
    MONTH_FIRST,
    DAY_FIRST
  }

  private static final int MONTHS = 12;
  private static final int THIS_CENTURY = 2000;

  private Order order; // null until a date tells it
  private LocalDate only; // the date that was read before, month first; null before it

  /**
   * Returns a day.
   *
   * @param year with four digits or the last two
   * @throws DateTimeException if it is none, or if the order of month and day matters and is
   *     unknown
   */
  LocalDate day(int first, int second, int year) {
    int fullYear = year < 100 ? THIS_CENTURY + year : year;
    Order told = first > MONTHS ? Order.DAY_FIRST : second > MONTHS ? Order.MONTH_FIRST : order;
    LocalDate day =
        told == Order.DAY_FIRST
            ? LocalDate.of(fullYear, second, first)
            : LocalDate.of(fullYear, first, second);
    boolean isGuessed = order == null && only != null; // what was read before
    if (isGuessed && told != Order.MONTH_FIRST && !day.equals(only)) {
      throw new DateTimeException("the order of month and day is unknown");
    }
    if (order != null && told != order) {
      throw new DateTimeException("month and day change places");
    }
    order = told;
    only = day;
    return day;
  }
}
