package org.hificamsim.runs.output;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.OpticsSpec;
import org.hificamsim.core.scenario.Scenario;

/** Writes the optics of a scenario's cameras, in the words of scenario files. */
final class OpticsFields {
  private final JsonGenerator json;

  private OpticsFields(JsonGenerator json) {
    this.json = json;
  }

  /** Writes {@code optics}, each once; nothing where no camera has any. */
  static void write(JsonGenerator json, Scenario scenario) throws IOException {
    List<OpticsSpec> all =
        scenario
            .everyCamera()
            .map(CameraSpec::optics)
            .flatMap(Optional::stream)
            .distinct()
            .toList();
    if (!all.isEmpty()) {
      json.writeArrayFieldStart("optics");
      for (OpticsSpec optics : all) {
        new OpticsFields(json).write(optics);
      }
      json.writeEndArray();
    }
  }

  private void write(OpticsSpec optics) throws IOException {
    json.writeStartObject();
    json.writeStringField("name", optics.name());
    json.writeStringField("law", Spelling.of(optics.law()));
    if (optics.pixels().isPresent()) {
      json.writeNumberField("pixels", optics.pixels().get());
    }
    numbers("hfov", optics.anglesOfView());
    number("reach", optics.reach());
    numbers("pan", optics.pans());
    if (optics.takesTime()) {
      number("pan_speed", optics.panSpeed());
      json.writeNumberField("zoom_time", optics.zoomTime());
      json.writeStringField("moving", Spelling.of(optics.moving()));
    }
    json.writeEndObject();
  }

  private void number(String name, OptionalDouble value) throws IOException {
    if (value.isPresent()) {
      json.writeNumberField(name, value.getAsDouble());
    }
  }

  private void numbers(String name, List<Double> values) throws IOException {
    json.writeArrayFieldStart(name);
    for (double value : values) {
      json.writeNumber(value);
    }
    json.writeEndArray();
  }
}
