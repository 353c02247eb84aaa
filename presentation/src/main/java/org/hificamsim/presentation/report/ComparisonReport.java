package org.hificamsim.presentation.report;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.hificamsim.data.CsvRow;
import org.hificamsim.data.CsvRows;
import org.hificamsim.presentation.figures.PolicyColors;
import org.hificamsim.runs.compare.AggregateFiles;
import org.hificamsim.runs.compare.ComparisonFiles;
import org.hificamsim.runs.output.ResultFolder;
import org.hificamsim.runs.output.Table;

/**
 * The page of a comparison, a reproduction, a sensitivity analysis or a ladder: its tables and
 * pictures, made from its folder alone.
 */
final class ComparisonReport {
  /** The tables that stand on the page as they are, in its order. */
  private static final List<String> OTHERS =
      List.of(
          "adapting.csv",
          "verdicts.csv",
          "table-8.1.csv",
          "sensitivity.csv",
          "fit.csv",
          "rungs.csv",
          "ladder.csv",
          AggregateFiles.AGGREGATE.file(),
          AggregateFiles.IMPROVEMENT.file(),
          AggregateFiles.PAIRS.file());

  private static final int MAX_ROWS = 5_000;
  private static final int MAX_SUMMARY_ROWS = 20_000;

  private final Path folder;
  private final ObjectNode data = new ObjectMapper().createObjectNode();

  private ComparisonReport(Path folder) {
    this.folder = folder;
  }

  /** Whether a folder holds any table that this page shows. */
  static boolean suits(Path folder) {
    return ComparisonFiles.SUMMARY.isIn(folder)
        || OTHERS.stream().anyMatch(name -> Table.of(name).isIn(folder));
  }

  /**
   * The page.
   *
   * @throws org.hificamsim.core.InputException when a table is missing, broken, or of another
   *     comparison than the rest
   */
  static Page of(Path folder) throws IOException {
    ComparisonReport report = new ComparisonReport(folder);
    report.addTables();
    if (ComparisonFiles.SUMMARY.isIn(folder)) {
      report.addComparison();
    }
    report.data.set("pictures", Pictures.of(folder));
    ResultFolder files = new ResultFolder(folder);
    report.data.put("command", files.command());
    report.data.put("version", files.version());
    String name = folder.toAbsolutePath().normalize().getFileName().toString();
    report.data.put("title", name);
    return new Page(
        name,
        "comparison-page.js",
        "comparisonPage",
        new ObjectMapper().writeValueAsString(report.data));
  }

  private void addTables() throws IOException {
    ArrayNode tables = data.putArray("tables");
    for (String name : OTHERS) {
      Table<?> table = Table.of(name);
      if (table.isIn(folder)) {
        write(tables.addObject(), table.read(folder), MAX_ROWS);
      }
    }
  }

  private void addComparison() throws IOException {
    CsvRows summary = ComparisonFiles.SUMMARY.read(folder);
    CsvRows results = ComparisonFiles.RESULTS.read(folder);
    ComparisonCheck.check(summary, results);
    write(data.putObject("summary"), summary, MAX_SUMMARY_ROWS);
    write(data.putObject("results"), results, MAX_ROWS);
    JsonNode settings = new ResultFolder(folder).json(ResultFolder.SETTINGS);
    data.set("settings", settings);
    if (ComparisonFiles.STEPS.isIn(folder)) {
      data.set("curves", CaseCurves.of(folder, settings));
    }
    addColors(summary);
  }

  private void addColors(CsvRows summary) {
    List<String> policies =
        summary.rows().stream().map(row -> row.text("policy")).distinct().toList();
    PolicyColors colors = new PolicyColors(policies);
    ObjectNode node = data.putObject("colours");
    policies.forEach(
        policy ->
            node.put(
                policy,
                String.format(Locale.ROOT, "#%06x", colors.of(policy).getRGB() & 0xffffff)));
  }

  private static void write(ObjectNode node, CsvRows table, int max) {
    node.put("name", table.file().getFileName().toString());
    node.put("count", table.rows().size());
    node.putPOJO("columns", table.columns());
    node.putPOJO("rows", table.rows().stream().limit(max).map(CsvRow::texts).toList());
  }
}
