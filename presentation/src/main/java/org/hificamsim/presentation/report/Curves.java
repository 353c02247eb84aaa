package org.hificamsim.presentation.report;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.runs.output.TableFile;

/** k_min over time of all cases, in few enough points for a page. */
final class Curves {
  private static final int MAX_POINTS_OF_A_CASE = 1_000;
  private static final int MAX_POINTS = 150_000;
  private static final double ROUNDING = 1e4;

  private Curves() {}

  /**
   * The curves: {@code steps} that each point is a mean over, and a list {@code cases} of {@code
   * scenario}, {@code detection}, {@code policy}, {@code k_min}.
   *
   * @param table rows of a case by step
   */
  static ObjectNode of(TableFile table) {
    Map<List<String>, double[]> cases = new LinkedHashMap<>();
    Map<List<String>, Integer> lengths = new LinkedHashMap<>();
    for (int row = 0; row < table.rows().size(); row++) {
      lengths.merge(table.caseOf(row), 1, Integer::sum);
    }
    int longest = lengths.values().stream().mapToInt(length -> length).max().orElse(1);
    int most =
        Math.max(2, Math.min(MAX_POINTS_OF_A_CASE, MAX_POINTS / Math.max(1, lengths.size())));
    int group = (longest + most - 1) / most;
    for (int row = 0; row < table.rows().size(); row++) {
      List<String> key = table.caseOf(row);
      int length = lengths.get(key);
      double[] sums = cases.computeIfAbsent(key, any -> new double[(length + group - 1) / group]);
      int point = (int) table.number(row, "step") / group;
      if (point >= 0 && point < sums.length) {
        sums[point] += table.number(row, "k_min") / Math.min(group, length - point * group);
      }
    }
    return node(cases, group);
  }

  private static ObjectNode node(Map<List<String>, double[]> cases, int group) {
    ObjectNode node = new ObjectMapper().createObjectNode().put("steps", group);
    ArrayNode list = node.putArray("cases");
    cases.forEach(
        (key, means) -> {
          Arrays.setAll(means, i -> Math.round(means[i] * ROUNDING) / ROUNDING);
          ObjectNode one = list.addObject();
          one.put("scenario", key.get(0)).put("detection", key.get(1)).put("policy", key.get(2));
          one.putPOJO("k_min", means);
        });
    return node;
  }
}
