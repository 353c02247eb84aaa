package org.hificamsim.presentation.report;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.InputException;

/** What a command left in its folder. */
final class ReportFiles {
  private ReportFiles() {}

  /**
   * A JSON file.
   *
   * @throws InputException when it is missing or no JSON object
   */
  static JsonNode json(Path folder, String name) throws IOException {
    Path file = folder.resolve(name);
    require(file);
    try {
      JsonNode node = new ObjectMapper().readTree(file.toFile());
      if (node.isObject() || node.isArray()) {
        return node;
      }
    } catch (JsonProcessingException e) {
      throw new InputException(
          "%s:%d:%d: not JSON, expected what 'hificamsim' writes"
              .formatted(file, e.getLocation().getLineNr(), e.getLocation().getColumnNr()),
          e);
    }
    throw new InputException(file + ": not a JSON object, expected what 'hificamsim' writes");
  }

  /**
   * Checks that there is such a file.
   *
   * @throws InputException when there is not
   */
  static void require(Path file) {
    if (!Files.isRegularFile(file)) {
      throw new InputException(
          "no file '"
              + file
              + "', expected a folder that 'hificamsim run --record' or 'hificamsim compare'"
              + " wrote");
    }
  }

  /** The command line that made the folder, each word quoted as a shell needs it. */
  static String command(Path folder) throws IOException {
    List<String> words = new ArrayList<>(List.of("./hificamsim"));
    for (JsonNode word : json(folder, "manifest.json").path("command")) {
      String text = word.asText();
      boolean plain = text.matches("[\\w./:=,@+-]+");
      words.add(plain ? text : "'" + text.replace("'", "'\\''") + "'");
    }
    return String.join(" ", words);
  }

  /** The version that made the folder. */
  static String version(Path folder) throws IOException {
    return json(folder, "manifest.json").path("hificamsim").asText();
  }
}
