package org.hificamsim.presentation.report;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.data.CsvRow;
import org.hificamsim.runs.compare.ComparisonFiles;
import org.hificamsim.runs.output.ResultFolder;
import org.hificamsim.runs.output.Table;

/** The score over time of all cases, in few enough points for a page. */
final class CaseCurves {
  private static final int MAX_POINTS_OF_A_CASE = 1_000;
  private static final int MAX_POINTS = 150_000;
  private static final String SCORE = "score";
  private static final double ROUNDING = 1e4;

  private CaseCurves() {}

  /**
   * The curves: {@code steps} that each point is a mean over, and a list {@code cases} of {@code
   * scenario}, {@code detection}, {@code policy}, {@code score}: k_min where a folder of version
   * 0.1.0 has no other.
   *
   * @param folder whose table of steps, which may be too large to hold, is read
   * @param settings of the plans: how many steps each has
   * @throws InputException when the table is broken, or has a case that the settings lack
   */
  static ObjectNode of(Path folder, JsonNode settings) throws IOException {
    Map<List<String>, Integer> lengths = lengths(folder, settings);
    int longest = lengths.values().stream().mapToInt(length -> length).max().orElse(1);
    int most =
        Math.max(2, Math.min(MAX_POINTS_OF_A_CASE, MAX_POINTS / Math.max(1, lengths.size())));
    int group = (longest + most - 1) / most;
    Map<List<String>, double[]> cases = new LinkedHashMap<>();
    ComparisonFiles.STEPS.read(
        folder,
        row -> {
          List<String> key = Table.caseOf(row);
          int length = length(lengths, row, key);
          double[] sums =
              cases.computeIfAbsent(key, any -> new double[(length + group - 1) / group]);
          int point = (int) row.numberOrNaN("step") / group;
          if (point >= 0 && point < sums.length) {
            sums[point] +=
                row.numberOrNaN(row.has(SCORE) ? SCORE : "k_min")
                    / Math.min(group, length - point * group);
          }
        });
    return node(cases, group);
  }

  private static Map<List<String>, Integer> lengths(Path folder, JsonNode settings) {
    Map<List<String>, Integer> lengths = new HashMap<>();
    for (JsonNode plan : settings) {
      int steps = plan.path("steps").asInt();
      if (steps < 1 || steps > Scenario.MAX_STEPS) {
        throw InputException.of(
            "%s: steps is %s, expected 1 to %s",
            folder.resolve(ResultFolder.SETTINGS), steps, Scenario.MAX_STEPS);
      }
      lengths.put(
          List.of(
              plan.path("scenario").asText(),
              plan.path("detection").asText(),
              plan.path("policy").asText()),
          steps);
    }
    return lengths;
  }

  private static int length(Map<List<String>, Integer> lengths, CsvRow row, List<String> key) {
    Integer length = lengths.get(key);
    if (length == null) {
      throw row.place(0)
          .error(
              "%s is not in %s, expected the files of one comparison",
              String.join(", ", key), ResultFolder.SETTINGS);
    }
    return length;
  }

  private static ObjectNode node(Map<List<String>, double[]> cases, int group) {
    ObjectNode node = new ObjectMapper().createObjectNode().put("steps", group);
    ArrayNode list = node.putArray("cases");
    cases.forEach(
        (key, means) -> {
          Arrays.setAll(means, i -> Math.round(means[i] * ROUNDING) / ROUNDING);
          ObjectNode one = list.addObject();
          one.put("scenario", key.get(0)).put("detection", key.get(1)).put("policy", key.get(2));
          one.putPOJO(SCORE, means);
        });
    return node;
  }
}
