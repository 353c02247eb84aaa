package org.hificamsim.experiments.output;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.Writer;
import java.util.List;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.experiments.run.Estimate;
import org.hificamsim.experiments.run.Metric;
import org.hificamsim.experiments.run.RunPlan;
import org.hificamsim.experiments.run.RunResult;

/** Writes {@code summary.json}: every setting, and the coverage of the run or of its repeats. */
public final class SummaryFile {
  private static final double WHOLE = 1L << 53;

  private final JsonGenerator json;

  private SummaryFile(JsonGenerator json) {
    this.json = json;
  }

  /** Writes and closes the file. */
  public static void write(Writer writer, RunPlan plan, List<RunResult> results)
      throws IOException {
    try (JsonGenerator json = new JsonFactory().createGenerator(writer)) {
      json.useDefaultPrettyPrinter();
      json.writeStartObject();
      SummaryFile file = new SummaryFile(json);
      file.settings(plan);
      file.figures(results);
      file.runs(results);
      json.writeEndObject();
      json.writeRaw('\n');
    }
  }

  private void settings(RunPlan plan) throws IOException {
    Scenario scenario = plan.scenario();
    json.writeStringField("scenario", scenario.name());
    json.writeStringField("detection", plan.detection().model().name());
    json.writeNumberField("threshold", plan.detection().threshold());
    json.writeStringField("policy", plan.policy());
    json.writeNumberField("steps", plan.steps());
    json.writeNumberField("seed", plan.seed());
    json.writeNumberField("repeat", plan.repeats());
    json.writeStringField("order", Spelling.of(scenario.order()));
    json.writeStringField("headings", Spelling.of(scenario.headings()));
    json.writeArrayFieldStart("zooms");
    for (double radius : scenario.zooms()) {
      json.writeNumber(radius);
    }
    json.writeEndArray();
    json.writeNumberField("cameras", scenario.cameras().size());
  }

  private void figures(List<RunResult> results) throws IOException {
    for (Metric metric : Metric.values()) {
      if (results.size() == 1 && metric.label().equals("performance")) {
        json.writeNumberField("performance", results.get(0).performance());
      } else {
        json.writeNumberField(metric.label(), Estimate.of(results, metric).mean());
      }
    }
    if (results.size() > 1) {
      json.writeObjectFieldStart("interval_95");
      for (Metric metric : Metric.values()) {
        Estimate estimate = Estimate.of(results, metric);
        json.writeArrayFieldStart(metric.label());
        json.writeNumber(estimate.low());
        json.writeNumber(estimate.high());
        json.writeEndArray();
      }
      json.writeEndObject();
    }
  }

  private void runs(List<RunResult> results) throws IOException {
    json.writeArrayFieldStart("runs");
    for (RunResult result : results) {
      json.writeStartObject();
      json.writeNumberField("run", result.run());
      json.writeNumberField("seed", result.seed());
      for (Metric metric : Metric.values()) {
        json.writeFieldName(metric.label());
        number(metric.of(result));
      }
      json.writeEndObject();
    }
    json.writeEndArray();
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
