package org.hificamsim.profiling.report;

import java.util.Map;
import org.hificamsim.core.Texts;
import org.hificamsim.profiling.fit.Coefficient;

/** Formats numbers and published texts as the cells of tables. */
final class CellText {
  private static final String NONE = "-";

  private CellText() {}

  /** Returns a number with this many digits after the decimal point. */
  static String fixed(double value, int digits) {
    if (!Double.isFinite(value)) {
      return NONE;
    }
    String text = Texts.format("%." + digits + "f", value);
    return text.matches("-0(\\.0*)?") ? text.substring(1) : text;
  }

  /** Returns a number with three significant digits. */
  static String significant(double value) {
    return Double.isFinite(value) ? Texts.format("%.3g", value) : NONE;
  }

  /** Returns a range of numbers; a dash if both are unknown. */
  static String span(double low, double high) {
    return Double.isFinite(low) || Double.isFinite(high)
        ? significant(low) + " to " + significant(high)
        : NONE;
  }

  /** Returns a published text, or a dash if the thesis has none. */
  static String published(Map<String, String> row, String column) {
    String text = row.getOrDefault(column, "");
    return text.isEmpty() ? NONE : text;
  }

  /** Returns the data set's number, followed by the published one in brackets if there is one. */
  static String withPublished(double yours, int digits, Map<String, String> row, String column) {
    String theirs = published(row, column);
    return fixed(yours, digits) + (theirs.equals(NONE) ? "" : " (" + theirs + ")");
  }

  /** Returns a coefficient with its 95% interval. */
  static String interval(Coefficient c) {
    return Double.isNaN(c.error())
        ? significant(c.value())
        : significant(c.value()) + " [" + significant(c.low()) + ", " + significant(c.high()) + "]";
  }
}
