package org.hificamsim.hifi.model;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.core.util.Separators;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Map;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.hifi.optics.Optics;

/** Writes what {@link ModelFormat} reads, one property a line, each number to its last bit. */
final class ModelWriter {
  private static final DefaultIndenter LINES = new DefaultIndenter("  ", "\n");
  private static final int ROWS_LEVEL = 3;

  private final JsonGenerator json;

  private ModelWriter(JsonGenerator json) {
    this.json = json;
  }

  static byte[] bytes(HiFiDetection model) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (JsonGenerator json = new JsonFactory().createGenerator(bytes)) {
      json.setPrettyPrinter(printer());
      new ModelWriter(json).write(model);
    }
    return bytes.toByteArray();
  }

  private void write(HiFiDetection model) throws IOException {
    json.writeStartObject();
    json.writeStringField("schema", ModelFormat.SCHEMA);
    json.writeNumberField("version", ModelFormat.VERSION);
    json.writeStringField("name", model.name());
    json.writeObjectFieldStart("f");
    FeatureFormats.write(model.f(), json);
    json.writeEndObject();
    write(model.g());
    write(model.optics());
    json.writeNumberField("threshold", model.defaultThreshold());
    writeUnits();
    writeRemarks(model.provenance().remarks());
    json.writeEndObject();
    json.writeRaw('\n');
  }

  private void write(DetectorLine g) throws IOException {
    json.writeObjectFieldStart("g");
    json.writeNumberField("slope", g.slope());
    json.writeNumberField("intercept", g.intercept());
    json.writeEndObject();
  }

  private void write(Optics optics) throws IOException {
    json.writeObjectFieldStart("optics");
    json.writeNumberField("sensorWidth", optics.sensorWidth());
    json.writeNumberField("longestFocalLength", optics.longestFocalLength());
    json.writeEndObject();
  }

  private void writeUnits() throws IOException {
    json.writeObjectFieldStart("units");
    for (String length : ModelFormat.LENGTHS) {
      json.writeStringField(length, "m");
    }
    json.writeEndObject();
  }

  private void writeRemarks(Map<String, String> remarks) throws IOException {
    json.writeObjectFieldStart("provenance");
    for (Map.Entry<String, String> remark : remarks.entrySet()) {
      json.writeStringField(remark.getKey(), remark.getValue());
    }
    json.writeEndObject();
  }

  private static DefaultPrettyPrinter printer() {
    DefaultPrettyPrinter printer =
        new DefaultPrettyPrinter(
            Separators.createDefaultInstance()
                .withObjectFieldValueSpacing(Separators.Spacing.AFTER));
    printer.indentObjectsWith(LINES);
    printer.indentArraysWith(new RowIndenter());
    return printer;
  }

  /** Puts each row of a table on a line of its own, and its cells side by side. */
  private static final class RowIndenter extends DefaultPrettyPrinter.NopIndenter {
    private static final long serialVersionUID = 1L;

    @Override
    public void writeIndentation(JsonGenerator json, int level) throws IOException {
      if (level < ROWS_LEVEL || !json.getOutputContext().getParent().inArray()) {
        LINES.writeIndentation(json, level);
      }
    }

    @Override
    public boolean isInline() {
      return false;
    }
  }
}
