package org.hificamsim.runs.output;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.file.OutputFolder;

/**
 * Writes {@code manifest.json}: when, with what, and how long. Like {@code ro-crate-metadata.json},
 * made of it, it differs by run.
 */
public final class ManifestFile {
  private ManifestFile() {}

  /** Adds the file to a folder's. */
  public static void write(OutputFolder folder, List<String> command, Instant started, long steps)
      throws IOException {
    write(folder, command, started, steps, SourceCommit.asked());
  }

  /** The same with a commit that was asked for before. */
  static void write(
      OutputFolder folder, List<String> command, Instant started, long steps, SourceCommit asked)
      throws IOException {
    double seconds = Duration.between(started, Instant.now()).toMillis() / 1000.0;
    Optional<String> commit = asked.name();
    JsonOutput.write(
        folder,
        ResultFolder.MANIFEST,
        json -> {
          json.writeStartObject();
          json.writeArrayFieldStart("command");
          for (String word : command) {
            json.writeString(word);
          }
          json.writeEndArray();
          json.writeStringField("started", started.toString());
          json.writeNumberField("seconds", seconds);
          json.writeNumberField("steps", steps);
          json.writeStringField("hificamsim", version());
          if (commit.isPresent()) {
            json.writeStringField("commit", commit.get());
          }
          json.writeStringField("java", System.getProperty("java.vm.version"));
          json.writeStringField(
              "system", System.getProperty("os.name") + " " + System.getProperty("os.arch"));
          json.writeEndObject();
        });
  }

  /** The version in this jar's manifest. */
  public static String version() {
    String version = ManifestFile.class.getPackage().getImplementationVersion();
    return version == null ? "development" : version;
  }
}
