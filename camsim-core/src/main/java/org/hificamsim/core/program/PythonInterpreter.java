package org.hificamsim.core.program;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The Python that runs a user's files.
 *
 * @param executable the file of the interpreter
 * @param folders the folders of its library and packages
 */
public record PythonInterpreter(Path executable, List<Path> folders) {
  /** The folders of this package, where it is installed, that a policy must not read. */
  private static final List<String> TRUTH = List.of("hificamsim/jars", "hificamsim/scenarios");

  /** The interpreters that were found, by command. */
  private static final Map<String, PythonInterpreter> FOUND = new HashMap<>();

  /** The environment variable that names another interpreter. */
  public static final String VARIABLE = "HIFICAMSIM_PYTHON";

  /** The system property that names the interpreter that called Java, if one did. */
  public static final String CALLER = "hificamsim.python";

  private static final String SCRIPT =
      """
      import os, sys
      print(sys.executable)
      for folder in [sys.prefix, sys.base_prefix, *filter(os.path.isdir, sys.path)]:
          print(folder, os.path.realpath(folder), sep="\\n")
      """;

  /**
   * Asks the interpreter that the user names, the caller, or {@code python3}; each of them once.
   *
   * @throws IOException when it cannot be run
   */
  public static synchronized PythonInterpreter find() throws IOException {
    String caller = System.getProperty(CALLER, "python3");
    String command = System.getenv().getOrDefault(VARIABLE, caller);
    PythonInterpreter found = FOUND.get(command);
    if (found == null) {
      found = ask(command);
      FOUND.put(command, found);
    }
    return found;
  }

  private static PythonInterpreter ask(String command) throws IOException {
    Process process = new ProcessBuilder(command, "-I", "-c", SCRIPT).start();
    process.getOutputStream().close();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    List<Path> found = said.lines().filter(line -> !line.isBlank()).map(Path::of).toList();
    if (found.isEmpty()) {
      throw new IOException(command + " says nothing");
    }
    return new PythonInterpreter(
        found.get(0), found.stream().skip(1).distinct().filter(path -> isBelowRoot(path)).toList());
  }

  /** The folders of the simulator and its scenarios among its packages. */
  public List<Path> simulator() {
    return folders.stream()
        .flatMap(folder -> TRUTH.stream().map(folder::resolve))
        .filter(Files::isDirectory)
        .toList();
  }

  private static boolean isBelowRoot(Path path) {
    return path.getNameCount() > 0;
  }
}
