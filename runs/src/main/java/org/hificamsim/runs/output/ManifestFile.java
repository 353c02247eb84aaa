package org.hificamsim.runs.output;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
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
    write(folder, command, started, steps, SourceCommit.name());
  }

  /** The same with the commit that a longer run began with. */
  static void write(
      OutputFolder folder,
      List<String> command,
      Instant started,
      long steps,
      Optional<String> commit)
      throws IOException {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    ArrayNode words = json.putArray("command");
    command.forEach(words::add);
    json.put("started", started.toString());
    json.put("seconds", Duration.between(started, Instant.now()).toMillis() / 1000.0);
    json.put("steps", steps);
    json.put("hificamsim", version());
    commit.ifPresent(name -> json.put("commit", name));
    json.put("java", System.getProperty("java.vm.version"));
    json.put("system", System.getProperty("os.name") + " " + System.getProperty("os.arch"));
    JsonOutput.write(folder, ResultFolder.MANIFEST, json);
  }

  /** The version in this jar's manifest. */
  public static String version() {
    String version = ManifestFile.class.getPackage().getImplementationVersion();
    return version == null ? "development" : version;
  }
}
