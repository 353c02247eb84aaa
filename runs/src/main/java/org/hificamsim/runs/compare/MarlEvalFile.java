package org.hificamsim.runs.compare;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.output.JsonOutput;

/**
 * Writes {@code marl-eval.json}, the raw data that marl-eval reads (Gorsane et al., Towards a
 * Standardised Performance Evaluation Protocol for Cooperative MARL, 2022): environment, task,
 * algorithm, run, logged step. Here they are detection, scenario, policy, seed, and {@link
 * PartMeans part of the run}.
 */
public final class MarlEvalFile {
  private static final String NAME = "marl-eval.json";

  private final JsonGenerator json;
  private final boolean proportions;

  private MarlEvalFile(JsonGenerator json, List<CaseResult> cases) {
    this.json = json;
    this.proportions =
        cases.stream().noneMatch(one -> one.plan().objective().hasOwnFigure())
            && cases.stream()
                .flatMap(one -> one.runs().stream())
                .allMatch(run -> run.optimum() > 0);
  }

  /**
   * Adds the file to a folder's. All runs in it need the same metrics: proportions of the optimum
   * are left out where an optimum is 0, and where it is not of k_min, whose course is logged.
   */
  public static void write(OutputFolder folder, List<CaseResult> cases) throws IOException {
    JsonOutput.write(folder, NAME, json -> new MarlEvalFile(json, cases).environments(cases));
  }

  private void environments(List<CaseResult> cases) throws IOException {
    json.writeStartObject();
    for (var environment : by(cases, one -> one.plan().detection().name()).entrySet()) {
      json.writeObjectFieldStart(environment.getKey());
      for (var task : by(environment.getValue(), one -> one.plan().scenario().name()).entrySet()) {
        json.writeObjectFieldStart(task.getKey());
        for (CaseResult one : task.getValue()) {
          algorithm(one);
        }
        json.writeEndObject();
      }
      json.writeEndObject();
    }
    json.writeEndObject();
  }

  /** An algorithm's name must not have a comma there. */
  private void algorithm(CaseResult one) throws IOException {
    json.writeObjectFieldStart(one.plan().policy().replace(',', ';'));
    for (int repeat = 0; repeat < one.runs().size(); repeat++) {
      ScoredRun run = one.runs().get(repeat);
      json.writeObjectFieldStart("seed_" + run.result().seed());
      double[] levels = one.levels()[repeat];
      for (int part = 0; part < levels.length; part++) {
        json.writeObjectFieldStart("step_" + (part + 1));
        int end = PartMeans.start(part + 1, levels.length, one.plan().steps());
        json.writeNumberField("step_count", end);
        metrics(one, run, levels[part]);
      }
      json.writeObjectFieldStart("absolute_metrics");
      metrics(one, run, run.result().meanKMin());
      json.writeEndObject();
    }
    json.writeEndObject();
  }

  /** The level beside that of the optimum over the whole run: the parts' mean is the run's. */
  private void metrics(CaseResult one, ScoredRun run, double level) throws IOException {
    metric("k_min", level);
    if (proportions) {
      metric("proportion_of_optimal", level * one.plan().steps() / run.optimum());
    }
    json.writeEndObject();
  }

  private void metric(String name, double value) throws IOException {
    json.writeArrayFieldStart(name);
    json.writeNumber(value);
    json.writeEndArray();
  }

  private static Map<String, List<CaseResult>> by(
      List<CaseResult> cases, Function<CaseResult, String> name) {
    return cases.stream()
        .collect(Collectors.groupingBy(name, LinkedHashMap::new, Collectors.toList()));
  }
}
