package org.hificamsim.hifi.model;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.core.util.Separators;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import org.hificamsim.hifi.HiFiDetection;

/** Writes what {@link ModelFormat} reads, one property a line, each number to its last bit. */
final class ModelWriter {
  static final ObjectMapper MAPPER = new ObjectMapper();
  private static final DefaultIndenter LINES = new DefaultIndenter("  ", "\n");
  private static final int ROWS_LEVEL = 3;

  private ModelWriter() {}

  static byte[] bytes(HiFiDetection model) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    MAPPER.writer(printer()).writeValue(bytes, json(model));
    bytes.write('\n');
    return bytes.toByteArray();
  }

  private static ObjectNode json(HiFiDetection model) {
    ObjectNode json = MAPPER.createObjectNode();
    int version = ModelFormat.version(model);
    json.put("schema", ModelFormat.SCHEMA).put("version", version);
    json.put("name", model.name());
    json.set("f", FeatureFormats.json(model.f()));
    ObjectNode g = json.putObject("g").setAll(DetectorFormats.json(model.g(), version));
    model.rmse().ifPresent(rmse -> g.put("rmse", rmse));
    json.putPOJO("optics", model.optics());
    json.put("threshold", model.defaultThreshold());
    model.fitted().ifPresent(on -> json.putPOJO("fitted", on));
    ObjectNode units = json.putObject("units");
    ModelFormat.LENGTHS.forEach(length -> units.put(length, "m"));
    return json.putPOJO("provenance", model.provenance().remarks());
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
