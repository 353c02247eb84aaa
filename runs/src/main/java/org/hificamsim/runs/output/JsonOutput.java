package org.hificamsim.runs.output;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import org.hificamsim.core.file.OutputFolder;

/** Writes a JSON file, indented, with a line end after it. */
public final class JsonOutput {
  private JsonOutput() {}

  /** What the file holds. */
  @FunctionalInterface
  public interface Content {
    /** Writes it. */
    void write(JsonGenerator json) throws IOException;
  }

  /** Writes one. */
  public static void write(OutputFolder folder, String name, Content content) throws IOException {
    try (JsonGenerator json = new JsonFactory().createGenerator(folder.open(name))) {
      json.useDefaultPrettyPrinter();
      content.write(json);
      json.writeRaw('\n');
    }
  }
}
