package org.hificamsim.core.program;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;

/**
 * The Python that runs a user's files.
 *
 * @param executable the file of the interpreter
 * @param folders the folders of its library and packages
 */
public record PythonInterpreter(Path executable, List<Path> folders) {
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
   * Asks the interpreter that the user names, the caller, or {@code python3}.
   *
   * @throws IOException when it cannot be run
   */
  public static PythonInterpreter find() throws IOException {
    String caller = System.getProperty(CALLER, "python3");
    String command = System.getenv().getOrDefault(VARIABLE, caller);
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

  private static boolean isBelowRoot(Path path) {
    return path.getNameCount() > 0;
  }
}
