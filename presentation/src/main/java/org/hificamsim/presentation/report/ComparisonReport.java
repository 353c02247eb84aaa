package org.hificamsim.presentation.report;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.presentation.figures.PolicyColors;

/**
 * The page of a comparison, a reproduction or a sensitivity analysis: its tables and pictures, made
 * from its folder alone.
 */
final class ComparisonReport {
  private static final String SUMMARY = "summary.csv";
  private static final String RESULTS = "results.csv";
  private static final String STEPS = "steps.csv.gz";
  private static final List<String> OTHERS =
      List.of("verdicts.csv", "table-8.1.csv", "sensitivity.csv");
  private static final int MOST_ROWS = 5_000;
  private static final int MOST_SUMMARY_ROWS = 20_000;

  private final Path folder;
  private final ObjectNode data = new ObjectMapper().createObjectNode();

  private ComparisonReport(Path folder) {
    this.folder = folder;
  }

  /** Whether a folder holds any table that this page shows. */
  static boolean suits(Path folder) {
    return Files.isRegularFile(folder.resolve(SUMMARY))
        || OTHERS.stream().anyMatch(name -> Files.isRegularFile(folder.resolve(name)));
  }

  /**
   * The page.
   *
   * @throws InputException when a table is missing, broken, or of another comparison than the rest
   */
  static Page of(Path folder) throws IOException {
    ComparisonReport report = new ComparisonReport(folder);
    report.addTables();
    if (Files.isRegularFile(folder.resolve(SUMMARY))) {
      report.addComparison();
    }
    report.data.set("pictures", Pictures.of(folder));
    report.data.put("command", ReportFiles.command(folder));
    report.data.put("version", ReportFiles.version(folder));
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
      if (Files.isRegularFile(folder.resolve(name))) {
        write(tables.addObject(), TableFile.read(folder.resolve(name)), MOST_ROWS);
      }
    }
  }

  private void addComparison() throws IOException {
    TableFile summary =
        TableFile.read(
            folder.resolve(SUMMARY),
            "scenario",
            "detection",
            "policy",
            "metric",
            "runs",
            "mean",
            "low",
            "high");
    TableFile results =
        TableFile.read(
            folder.resolve(RESULTS), "scenario", "detection", "policy", "seed", "performance");
    ComparisonCheck.check(summary, results);
    write(data.putObject("summary"), summary, MOST_SUMMARY_ROWS);
    write(data.putObject("results"), results, MOST_ROWS);
    data.set("settings", ReportFiles.json(folder, "settings.json"));
    if (Files.isRegularFile(folder.resolve(STEPS))) {
      data.set(
          "curves",
          Curves.of(
              TableFile.read(
                  folder.resolve(STEPS), "scenario", "detection", "policy", "step", "k_min")));
    }
    addColors(summary);
  }

  private void addColors(TableFile summary) {
    List<String> policies =
        IntStream.range(0, summary.rows().size())
            .mapToObj(row -> summary.text(row, "policy"))
            .distinct()
            .toList();
    PolicyColors colors = new PolicyColors(policies);
    ObjectNode node = data.putObject("colours");
    policies.forEach(
        policy -> node.put(policy, "#%06x".formatted(colors.of(policy).getRGB() & 0xffffff)));
  }

  private static void write(ObjectNode node, TableFile table, int most) {
    node.put("name", table.file().getFileName().toString());
    node.put("count", table.rows().size());
    ArrayNode columns = node.putArray("columns");
    table.columns().forEach(columns::add);
    ArrayNode rows = node.putArray("rows");
    for (String[] row : table.rows().subList(0, Math.min(most, table.rows().size()))) {
      ArrayNode cells = rows.addArray();
      for (String cell : row) {
        cells.add(cell);
      }
    }
  }
}
