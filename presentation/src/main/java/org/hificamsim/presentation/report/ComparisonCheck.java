package org.hificamsim.presentation.report;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.apache.commons.math3.stat.descriptive.SummaryStatistics;
import org.hificamsim.core.InputException;
import org.hificamsim.runs.compare.ComparisonFiles;
import org.hificamsim.runs.output.TableFile;

/** Compares {@code summary.csv} with {@code results.csv}: a page must not mix two comparisons. */
final class ComparisonCheck {
  private static final double ROUNDING = 1e-9;

  private ComparisonCheck() {}

  /**
   * @throws InputException when a case's mean performance is not that of its runs
   */
  static void check(TableFile summary, TableFile results) {
    Map<List<String>, SummaryStatistics> runs = new LinkedHashMap<>();
    for (int row = 0; row < results.rows().size(); row++) {
      runs.computeIfAbsent(results.caseOf(row), any -> new SummaryStatistics())
          .addValue(results.number(row, "performance"));
    }
    for (int row = 0; row < summary.rows().size(); row++) {
      double mean = summary.number(row, "mean");
      summary.number(row, "low");
      summary.number(row, "high");
      SummaryStatistics own = runs.get(summary.caseOf(row));
      if (own != null && summary.text(row, "metric").equals("performance")) {
        compare(summary, row, mean, own);
      }
    }
  }

  private static void compare(TableFile summary, int row, double mean, SummaryStatistics own) {
    boolean same = Math.abs(mean - own.getMean()) <= ROUNDING * Math.max(1, Math.abs(mean));
    if (!same || summary.number(row, "runs") != own.getN()) {
      throw new InputException(
          "%s:%s:1: mean performance %s of %s runs, but %s has %s of %s, expected the files of one comparison"
              .formatted(
                  summary.file(),
                  summary.line(row),
                  summary.text(row, "mean"),
                  summary.text(row, "runs"),
                  ComparisonFiles.RESULTS.file(),
                  own.getMean(),
                  own.getN()));
    }
  }
}
