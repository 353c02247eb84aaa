package org.hificamsim.presentation.report;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.regex.Pattern;
import org.hificamsim.runs.Metric;

/** Gives pages the title, unit and meaning of each metric, by its name in files. */
final class MetricNames {
  private static final Pattern LINK = Pattern.compile("\\[([^]]*)]\\([^)]*\\)");

  private MetricNames() {}

  static ObjectNode json() {
    ObjectNode names = new ObjectMapper().createObjectNode();
    for (Metric metric : Metric.values()) {
      names
          .putObject(metric.label())
          .put("title", metric.title())
          .put("unit", plain(metric.unit()))
          .put("meaning", plain(metric.meaning()));
    }
    return names;
  }

  /** Removes the links and code marks of {@code docs/data.md}. */
  private static String plain(String text) {
    return LINK.matcher(text).replaceAll("$1").replace("`", "");
  }
}
