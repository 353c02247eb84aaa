package org.hificamsim.runs.output;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;

/** Writes {@code summary.json}: every setting, and the metrics of the run or of its repeats. */
final class SummaryFile {
  private SummaryFile() {}

  /** Adds the file to a folder's. */
  static void write(OutputFolder folder, RunPlan plan, List<RunResult> results) throws IOException {
    ObjectNode json = SettingsFile.of(plan);
    List<Metric> metrics = Metric.ofRuns().stream().filter(results.get(0)::has).toList();
    metrics.forEach(metric -> mean(json, metric, results));
    if (results.size() > 1) {
      ObjectNode intervals = json.putObject("interval_95");
      for (Metric metric : metrics) {
        Estimate estimate = Estimate.of(results, metric);
        intervals.putArray(metric.label()).add(estimate.low()).add(estimate.high());
      }
    }
    ArrayNode runs = json.putArray("runs");
    for (RunResult result : results) {
      ObjectNode run = runs.addObject().put("run", result.run()).put("seed", result.seed());
      metrics.forEach(metric -> run.set(metric.label(), JsonOutput.number(result.value(metric))));
      Arrays.stream(Metric.values())
          .filter(metric -> metric.isClaim() && result.has(metric))
          .forEach(metric -> run.set(metric.label(), JsonOutput.number(result.value(metric))));
    }
    JsonOutput.write(folder, ResultFolder.SUMMARY, json);
  }

  /** Of a single run, what is a sum over its steps is written as in the list of runs. */
  private static void mean(ObjectNode json, Metric metric, List<RunResult> results) {
    double mean = Estimate.of(results, metric).mean();
    if (results.size() == 1 && (metric == Metric.PERFORMANCE || metric == Metric.SCORE)) {
      json.set(metric.label(), JsonOutput.number(mean));
    } else {
      json.put(metric.label(), mean);
    }
  }
}
