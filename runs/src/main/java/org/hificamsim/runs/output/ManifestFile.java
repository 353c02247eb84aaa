package org.hificamsim.runs.output;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.Writer;
import java.time.Duration;
import java.time.Instant;
import java.util.List;

/**
 * Writes {@code manifest.json}: when, with what, and how long; the one file that differs by run.
 */
public final class ManifestFile {
  private ManifestFile() {}

  /** Writes and closes the file. */
  public static void write(Writer writer, List<String> command, Instant started, long steps)
      throws IOException {
    Duration elapsed = Duration.between(started, Instant.now());
    try (JsonGenerator json = new JsonFactory().createGenerator(writer)) {
      json.useDefaultPrettyPrinter();
      json.writeStartObject();
      json.writeArrayFieldStart("command");
      for (String word : command) {
        json.writeString(word);
      }
      json.writeEndArray();
      json.writeStringField("started", started.toString());
      json.writeNumberField("seconds", elapsed.toMillis() / 1000.0);
      json.writeNumberField("steps", steps);
      json.writeStringField("hificamsim", version());
      json.writeStringField("java", System.getProperty("java.vm.version"));
      json.writeStringField(
          "system", System.getProperty("os.name") + " " + System.getProperty("os.arch"));
      json.writeEndObject();
      json.writeRaw('\n');
    }
  }

  /** The version in this jar's manifest. */
  public static String version() {
    String version = ManifestFile.class.getPackage().getImplementationVersion();
    return version == null ? "development" : version;
  }
}
