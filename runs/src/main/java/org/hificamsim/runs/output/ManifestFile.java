package org.hificamsim.runs.output;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.file.OutputFolder;

/**
 * Writes {@code manifest.json}: the command, when it started, on which system, and how long it
 * took. The file differs between equal runs, and so does {@code ro-crate-metadata.json}, which is
 * made from it.
 */
public final class ManifestFile {
  private ManifestFile() {}

  /** Adds the file to a folder's files. */
  public static void write(OutputFolder folder, List<String> command, Instant started, long steps)
      throws IOException {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    ArrayNode words = json.putArray("command");
    command.forEach(words::add);
    json.put("started", started.toString());
    json.put("seconds", Duration.between(started, Instant.now()).toMillis() / 1000.0);
    json.put("steps", steps);
    json.put("hificamsim", version());
    sourceCommit().ifPresent(name -> json.put("commit", name));
    json.put("java", System.getProperty("java.vm.version"));
    json.put("system", System.getProperty("os.name") + " " + System.getProperty("os.arch"));
    JsonOutput.write(folder, ResultFolder.MANIFEST, json);
  }

  /** The version of the program, from the manifest of its jar. */
  public static String version() {
    String version = ManifestFile.class.getPackage().getImplementationVersion();
    return version == null ? "development" : version;
  }

  /**
   * The commit from which the launcher built this program, with {@code -dirty} if files were
   * changed since; empty without Git.
   */
  private static Optional<String> sourceCommit() {
    Path root = Path.of(System.getProperty("hificamsim.root", ""));
    if (System.getProperty("hificamsim.root") == null || !Files.exists(root.resolve(".git"))) {
      return Optional.empty();
    }
    ProcessBuilder git =
        new ProcessBuilder("git", "describe", "--always", "--dirty", "--abbrev=40", "--exclude=*");
    git.directory(root.toFile()).redirectError(ProcessBuilder.Redirect.DISCARD);
    git.environment().put("GIT_OPTIONAL_LOCKS", "0");
    try {
      Process process = git.start();
      String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      return process.waitFor() == 0 ? Optional.of(output.strip()) : Optional.empty();
    } catch (IOException e) {
      return Optional.empty(); // no Git
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.empty();
    }
  }
}
