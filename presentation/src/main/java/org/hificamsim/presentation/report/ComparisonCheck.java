package org.hificamsim.presentation.report;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.apache.commons.math3.stat.descriptive.SummaryStatistics;
import org.hificamsim.data.CsvRow;
import org.hificamsim.data.CsvRows;
import org.hificamsim.runs.output.Table;

/** Compares {@code summary.csv} with {@code results.csv}: a page must not mix two comparisons. */
final class ComparisonCheck {
  private static final double ROUNDING = 1e-9;

  private ComparisonCheck() {}

  /**
   * @throws org.hificamsim.core.InputException when a case's mean performance is not that of its
   *     runs
   */
  static void check(CsvRows summary, CsvRows results) {
    Map<List<String>, SummaryStatistics> runs = new LinkedHashMap<>();
    for (CsvRow row : results.rows()) {
      runs.computeIfAbsent(Table.caseOf(row), any -> new SummaryStatistics())
          .addValue(row.numberOrNaN("performance"));
    }
    for (CsvRow row : summary.rows()) {
      double mean = row.numberOrNaN("mean");
      row.numberOrNaN("low");
      row.numberOrNaN("high");
      SummaryStatistics own = runs.get(Table.caseOf(row));
      if (own != null && row.text("metric").equals("performance")) {
        compare(row, mean, own);
      }
    }
  }

  private static void compare(CsvRow row, double mean, SummaryStatistics own) {
    boolean same = Math.abs(mean - own.getMean()) <= ROUNDING * Math.max(1, Math.abs(mean));
    if (!same || row.numberOrNaN("runs") != own.getN()) {
      throw row.place(0)
          .error(
              "mean performance %s of %s runs, but %s has %s of %s, expected the files of one comparison"
                  .formatted(
                      row.text("mean"),
                      row.text("runs"),
                      Table.RESULTS.file(),
                      own.getMean(),
                      own.getN()));
    }
  }
}
