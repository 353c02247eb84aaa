package org.hificamsim.runs.output;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.List;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.Proof;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;

/** Writes {@code summary.json}: every setting, and the coverage of the run or of its repeats. */
public final class SummaryFile {
  private static final double WHOLE = 1L << 53;

  private final JsonGenerator json;
  private final Objective objective;

  private SummaryFile(JsonGenerator json, Objective objective) {
    this.json = json;
    this.objective = objective;
  }

  /** Adds the file to a folder's. */
  public static void write(OutputFolder folder, RunPlan plan, List<RunResult> results)
      throws IOException {
    JsonOutput.write(
        folder,
        ResultFolder.SUMMARY,
        json -> {
          json.writeStartObject();
          SummaryFile file = new SummaryFile(json, plan.objective());
          SettingsFile.write(json, plan);
          List<Metric> metrics = Metric.measured(results.get(0));
          file.figures(metrics, results);
          file.runs(metrics, results);
          json.writeEndObject();
        });
  }

  private void figures(List<Metric> metrics, List<RunResult> results) throws IOException {
    for (Metric metric : metrics) {
      if (results.size() == 1 && (metric == Metric.PERFORMANCE || metric == Metric.SCORE)) {
        json.writeFieldName(metric.label());
        number(metric.of(results.get(0)));
      } else {
        json.writeNumberField(metric.label(), Estimate.of(results, metric).mean());
      }
    }
    if (results.size() > 1) {
      json.writeObjectFieldStart("interval_95");
      for (Metric metric : metrics) {
        Estimate estimate = Estimate.of(results, metric);
        json.writeArrayFieldStart(metric.label());
        json.writeNumber(estimate.low());
        json.writeNumber(estimate.high());
        json.writeEndArray();
      }
      json.writeEndObject();
    }
  }

  private void runs(List<Metric> metrics, List<RunResult> results) throws IOException {
    json.writeArrayFieldStart("runs");
    for (RunResult result : results) {
      json.writeStartObject();
      json.writeNumberField("run", result.run());
      json.writeNumberField("seed", result.seed());
      for (Metric metric : metrics) {
        json.writeFieldName(metric.label());
        number(metric.of(result));
      }
      if (result.proof().isPresent()) {
        proof(result.score(), result.proof().get());
      }
      json.writeEndObject();
    }
    json.writeEndArray();
  }

  private void proof(double score, Proof proof) throws IOException {
    json.writeNumberField("unproven_steps", proof.unprovenSteps());
    json.writeFieldName(Proof.boundLabel(objective));
    number(proof.bound(score));
  }

  /** Whole numbers without a fraction. */
  private void number(double value) throws IOException {
    if (value == Math.rint(value) && Math.abs(value) < WHOLE) {
      json.writeNumber((long) value);
    } else {
      json.writeNumber(value);
    }
  }
}
