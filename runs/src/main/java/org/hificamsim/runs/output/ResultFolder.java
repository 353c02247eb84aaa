package org.hificamsim.runs.output;

import static org.hificamsim.core.NamedSetting.setting;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFolder;

/** The folder that a command has written, with its files other than the {@link Table tables}. */
public record ResultFolder(Path path) {
  public static final String SUMMARY = "summary.json";
  public static final String SETTINGS = "settings.json";
  public static final String MANIFEST = "manifest.json";
  public static final String CRATE = "ro-crate-metadata.json";
  public static final String REPLAY = "replay.json";
  public static final String HEATMAP = "heatmap.csv";
  public static final String REPORT = "report.html";

  /**
   * The path of a file.
   *
   * @throws InputException when there is no such file
   */
  public Path file(String name) {
    Path file = path.resolve(name);
    if (!Files.isRegularFile(file)) {
      throw InputException.of(
          "no file '%s', expected a folder that 'run' with %s or 'compare' wrote",
          file, setting("record"));
    }
    return file;
  }

  /**
   * The content of a JSON file.
   *
   * @throws InputException when it is missing or not a JSON object or array
   */
  public JsonNode json(String name) throws IOException {
    Path file = file(name);
    try {
      JsonNode node = new ObjectMapper().readTree(file.toFile());
      if (node.isObject() || node.isArray()) {
        return node;
      }
    } catch (JsonProcessingException e) {
      throw InputException.of(
              "%s:%s:%s: not JSON, expected what 'hificamsim' writes",
              file, e.getLocation().getLineNr(), e.getLocation().getColumnNr())
          .because(e);
    }
    throw new InputException(file + ": not a JSON object, expected what 'hificamsim' writes");
  }

  /** The name by which pages call a result folder. */
  public static String name(Path folder) {
    return folder.toAbsolutePath().normalize().getFileName().toString();
  }

  /** The command line that made the folder, quoted for a shell. */
  public String command() throws IOException {
    List<String> words = new ArrayList<>();
    json(MANIFEST).path("command").forEach(word -> words.add(word.asText()));
    return command(words);
  }

  /** Joins words to a command line, quoted for a shell. */
  public static String command(List<String> words) {
    return Stream.concat(Stream.of("./hificamsim"), words.stream().map(ResultFolder::quoted))
        .collect(Collectors.joining(" "));
  }

  private static String quoted(String word) {
    boolean needsNoQuotes = word.matches("[\\w./:=,@+-]+");
    return needsNoQuotes ? word : "'" + word.replace("'", "'\\''") + "'";
  }

  /**
   * Moves the files of a command into place, and removes those of an earlier command: the files
   * that its crate names, and others.
   *
   * @param others files that a crate may not name
   */
  public static void commit(OutputFolder folder, List<String> others) throws IOException {
    Set<String> earlier = new HashSet<>(others);
    earlier.addAll(new ResultFolder(folder.path()).resultsOfLastCommand());
    folder.commit(earlier);
  }

  /**
   * The results of the last command, read from its RO-Crate, which would look like results of the
   * next command. Inputs are not among them, because the next command may read them. Empty if the
   * crate is missing or damaged.
   */
  private List<String> resultsOfLastCommand() {
    if (!Files.isRegularFile(path.resolve(CRATE))) {
      return List.of();
    }
    List<String> names = new ArrayList<>();
    try {
      for (JsonNode entity : json(CRATE).path("@graph")) {
        if (entity.path("@type").asText().equals("File")) {
          names.add(entity.path("name").asText());
        }
      }
    } catch (InputException | IOException e) {
      return List.of();
    }
    names.removeIf(name -> InputFiles.isInput(name) || !isHere(name));
    return names;
  }

  /** Whether a name is that of a file in this folder. */
  private boolean isHere(String name) {
    return name.matches("[^./][^/\\p{Cntrl}]*")
        && Files.isRegularFile(path.resolve(name), LinkOption.NOFOLLOW_LINKS);
  }

  /** The version that made the folder. */
  public String version() throws IOException {
    return json(MANIFEST).path("hificamsim").asText();
  }
}
