package org.hificamsim.presentation.report;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.StreamSupport;
import java.util.zip.Deflater;
import org.hificamsim.data.CsvRow;
import org.hificamsim.data.CsvRows;
import org.hificamsim.presentation.figures.FigureStyle;
import org.hificamsim.presentation.figures.PolicyColors;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.replay.Deflated;
import org.hificamsim.runs.compare.AggregateFiles;
import org.hificamsim.runs.compare.Choice;
import org.hificamsim.runs.compare.ComparisonFiles;
import org.hificamsim.runs.output.ResultFolder;
import org.hificamsim.runs.output.Table;

/**
 * Makes the page of a comparison, a reproduction, a sensitivity analysis or a ladder from the
 * tables and pictures of its folder.
 */
final class ComparisonReport {
  /** The tables that the page shows unchanged, in this order. */
  private static final List<String> PLAIN_TABLES =
      List.of(
          Choice.FILE.file(),
          "adapting.csv",
          "readings.csv",
          "verdicts.csv",
          "table-8.1.csv",
          "sensitivity.csv",
          "fit.csv",
          "rungs.csv",
          "ladder.csv",
          AggregateFiles.AGGREGATE.file(),
          AggregateFiles.IMPROVEMENT.file(),
          AggregateFiles.PAIRS.file());

  private static final int MAX_PICTURE_BYTES = 3_000_000;
  private static final int MAX_ROWS = 5_000;
  private static final int MAX_DRAWN_ROWS = 50_000;
  private static final int MAX_SUMMARY_ROWS = 20_000;

  private final Path folder;
  private final ObjectNode data = new ObjectMapper().createObjectNode();

  private ComparisonReport(Path folder) {
    this.folder = folder;
  }

  /** Whether a folder has a table that this page shows. */
  static boolean suits(Path folder) {
    return ComparisonFiles.SUMMARY.isIn(folder)
        || PLAIN_TABLES.stream().anyMatch(name -> Table.of(name).isIn(folder));
  }

  /**
   * Makes the page.
   *
   * @throws org.hificamsim.core.InputException if a table is missing or broken
   */
  static Page of(Path folder, String name) throws IOException {
    ComparisonReport report = new ComparisonReport(folder);
    report.addTables();
    if (ComparisonFiles.SUMMARY.isIn(folder)) {
      report.addComparison();
    }
    report.addPictures();
    ResultFolder files = new ResultFolder(folder);
    report.data.put("command", files.command());
    report.data.put("version", files.version());
    report.data.put("title", name);
    return new Page(
        name,
        "comparison-page.js",
        "comparisonPage",
        new ObjectMapper().writeValueAsString(report.data));
  }

  private void addTables() throws IOException {
    ArrayNode tables = data.putArray("tables");
    for (String name : PLAIN_TABLES) {
      Table<?> table = Table.of(name);
      if (table.isIn(folder)) {
        write(tables.addObject(), table.read(folder), MAX_ROWS);
      }
    }
  }

  private void addComparison() throws IOException {
    CsvRows summary = ComparisonFiles.SUMMARY.read(folder);
    CsvRows results = ComparisonFiles.RESULTS.read(folder);
    write(data.putObject("summary"), summary, MAX_SUMMARY_ROWS);
    write(data.putObject("results"), results, MAX_ROWS);
    for (Table<?> table : List.of(ComparisonFiles.LEVELS, ComparisonFiles.YARDSTICKS)) {
      if (table.isIn(folder)) {
        write(data.putObject(table.file().replace(".csv", "")), table.read(folder), MAX_DRAWN_ROWS);
      }
    }
    JsonNode settings = new ResultFolder(folder).json(ResultFolder.SETTINGS);
    data.set("settings", settings);
    data.set("names", MetricNames.json());
    addColors(summary);
  }

  /** Adds the deflated SVG pictures; those beyond the limit of bytes without their data. */
  private void addPictures() throws IOException {
    ArrayNode pictures = data.putArray("pictures");
    int bytes = 0;
    try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "*.svg")) {
      for (Path file : StreamSupport.stream(files.spliterator(), false).sorted().toList()) {
        String packed = Deflated.base64(Deflater.BEST_COMPRESSION, out -> Files.copy(file, out));
        bytes += packed.length();
        pictures
            .addObject()
            .put("name", file.getFileName().toString())
            .put("data", bytes <= MAX_PICTURE_BYTES ? packed : "");
      }
    }
  }

  private void addColors(CsvRows summary) throws IOException {
    List<String> policies =
        summary.rows().stream().map(row -> row.text("policy")).distinct().toList();
    FigureStyle style = FigureStyle.ofFolder(folder);
    PolicyColors colors = new PolicyColors(policies, style);
    data.putPOJO("labels", style.labels());
    ObjectNode node = data.putObject("colours");
    policies.forEach(policy -> node.put(policy, Palette.hex(colors.of(policy))));
  }

  static void write(ObjectNode node, CsvRows table, int maxRows) {
    node.put("name", table.file().getFileName().toString());
    node.put("count", table.rows().size());
    node.putPOJO("columns", table.columns());
    node.putPOJO("rows", table.rows().stream().limit(maxRows).map(CsvRow::texts).toList());
  }
}
