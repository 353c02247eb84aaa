package org.hificamsim.experiments.output;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.Writer;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.experiments.run.Estimate;
import org.hificamsim.experiments.run.RunPlan;
import org.hificamsim.experiments.run.RunResult;

/** Writes {@code summary.json}: every setting, and the coverage of the run or of its repeats. */
public final class SummaryFile {
  /** The figures of a run, by their name in files. */
  public static final Map<String, ToDoubleFunction<RunResult>> FIGURES = figures();

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
    for (Map.Entry<String, ToDoubleFunction<RunResult>> figure : FIGURES.entrySet()) {
      if (results.size() == 1 && figure.getKey().equals("performance")) {
        json.writeNumberField("performance", results.get(0).performance());
      } else {
        json.writeNumberField(figure.getKey(), Estimate.of(results, figure.getValue()).mean());
      }
    }
    if (results.size() > 1) {
      json.writeObjectFieldStart("interval_95");
      for (Map.Entry<String, ToDoubleFunction<RunResult>> figure : FIGURES.entrySet()) {
        Estimate estimate = Estimate.of(results, figure.getValue());
        json.writeArrayFieldStart(figure.getKey());
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
      json.writeNumberField("performance", result.performance());
      for (Map.Entry<String, ToDoubleFunction<RunResult>> figure : FIGURES.entrySet()) {
        if (!figure.getKey().equals("performance")) {
          json.writeNumberField(figure.getKey(), figure.getValue().applyAsDouble(result));
        }
      }
      json.writeEndObject();
    }
    json.writeEndArray();
  }

  private static Map<String, ToDoubleFunction<RunResult>> figures() {
    Map<String, ToDoubleFunction<RunResult>> figures = new LinkedHashMap<>();
    figures.put("performance", RunResult::performance);
    figures.put("mean_k_min", RunResult::meanKMin);
    figures.put("covered_0", RunResult::covered0);
    figures.put("covered_1", RunResult::covered1);
    figures.put("covered_k", RunResult::coveredK);
    figures.put("mean_k", RunResult::meanK);
    return java.util.Collections.unmodifiableMap(figures);
  }
}
