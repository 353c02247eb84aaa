package org.hificamsim.presentation.report;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Map;
import org.hificamsim.runs.benchmark.BenchmarkTask;
import org.hificamsim.runs.benchmark.Leaderboard;
import org.hificamsim.runs.output.ManifestFile;

/** Makes the page of the benchmark's leaderboard. */
public final class LeaderboardReport {
  private LeaderboardReport() {}

  /** Returns the page. */
  public static Page page(Leaderboard board) {
    List<String> columns = board.columns();
    ObjectNode data = new ObjectMapper().createObjectNode();
    data.put("version", ManifestFile.version());
    data.put("episodes", BenchmarkTask.TESTING.size());
    data.putPOJO("columns", columns);
    data.putPOJO("rows", board.rows().stream().map(row -> cells(columns, row)).toList());
    return new Page("Leaderboard", "leaderboard-page.js", "leaderboardPage", data.toString());
  }

  private static List<String> cells(List<String> columns, Map<String, String> row) {
    return columns.stream().map(row::get).toList();
  }
}
