package org.hificamsim.runs.output;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.runs.Lens;
import org.hificamsim.runs.RunPlan;

/** Every setting of a plan, as result files name them. */
public final class SettingsFile {
  private SettingsFile() {}

  /** Adds {@code settings.json}, one object per plan, to a folder's files. */
  public static void write(OutputFolder folder, List<RunPlan> plans) throws IOException {
    JsonOutput.write(
        folder,
        ResultFolder.SETTINGS,
        json -> {
          json.writeStartArray();
          for (RunPlan plan : plans) {
            json.writeStartObject();
            write(json, plan);
            json.writeEndObject();
          }
          json.writeEndArray();
        });
  }

  /** Writes the settings as fields of the object under way. */
  static void write(JsonGenerator json, RunPlan plan) throws IOException {
    Scenario scenario = plan.scenario();
    json.writeStringField("scenario", scenario.name());
    json.writeStringField("detection", plan.detection().name());
    json.writeNumberField("threshold", plan.detection().threshold());
    if (!plan.detection().certain()) {
      json.writeStringField("detect", plan.detection().rule().text());
    }
    json.writeStringField("policy", plan.policy());
    json.writeStringField("objective", plan.objective().text());
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
    OpticsFields.write(json, scenario);
    lens(json, plan);
  }

  /**
   * What the model looks through, metres: a focal length for each of the zooms, none for a model
   * without optics.
   */
  private static void lens(JsonGenerator json, RunPlan plan) throws IOException {
    Optional<Lens> lens = Lens.of(plan.detection(), plan.scenario());
    OptionalDouble height = lens.map(Lens::mountHeight).orElse(plan.scenario().mountHeight());
    if (height.isPresent()) {
      json.writeNumberField("mount_height", height.getAsDouble());
    } else {
      json.writeNullField("mount_height");
    }
    json.writeArrayFieldStart("focal_lengths");
    for (double focalLength : lens.map(Lens::focalLengths).orElse(List.of())) {
      json.writeNumber(focalLength);
    }
    json.writeEndArray();
  }
}
