package org.hificamsim.profiling.report;

import java.util.Locale;
import java.util.Map;
import org.hificamsim.profiling.fit.Coefficient;

/** Numbers and published texts as the cells of tables. */
final class Cells {
  private static final String NONE = "-";

  private Cells() {}

  /** A number with this many digits behind the point. */
  static String fixed(double value, int digits) {
    return Double.isFinite(value) ? String.format(Locale.ROOT, "%." + digits + "f", value) : NONE;
  }

  /** A number with three significant digits. */
  static String significant(double value) {
    return Double.isFinite(value) ? String.format(Locale.ROOT, "%.3g", value) : NONE;
  }

  /** A published text, or a dash where the thesis has none. */
  static String published(Map<String, String> row, String column) {
    String text = row.getOrDefault(column, "");
    return text.isEmpty() ? NONE : text;
  }

  /** Ours, then the published number in brackets. */
  static String beside(double ours, int digits, Map<String, String> row, String column) {
    return fixed(ours, digits) + " (" + published(row, column) + ")";
  }

  /** A coefficient with its 95% interval. */
  static String interval(Coefficient c) {
    return Double.isNaN(c.error())
        ? significant(c.value())
        : significant(c.value()) + " [" + significant(c.low()) + ", " + significant(c.high()) + "]";
  }
}
