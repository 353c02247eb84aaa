package org.hificamsim.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import javax.tools.ToolProvider;

/** Compiles sources for a test: another version of CamSim, or other classes on its class path. */
final class Variant {
  private static final Path SOURCES = CamSimRun.ROOT.resolve("camsim-bridge/src/doubles/java");

  private Variant() {}

  /**
   * Compiles the doubles with a text replaced, also in the names of files, and returns the folder
   * of the classes.
   */
  static Path of(Path folder, String text, String replacement) throws IOException {
    return of(folder, Map.of(text, replacement));
  }

  /** Does the same with several texts replaced. */
  static Path of(Path folder, Map<String, String> replacements) throws IOException {
    List<String> files = new ArrayList<>();
    Set<String> missing = new TreeSet<>(replacements.keySet());
    try (Stream<Path> sources = Files.walk(SOURCES)) {
      for (Path source : sources.filter(Files::isRegularFile).toList()) {
        String content = Files.readString(source);
        String name = SOURCES.relativize(source).toString();
        missing.removeIf(content::contains);
        for (Map.Entry<String, String> replacement : replacements.entrySet()) {
          content = content.replace(replacement.getKey(), replacement.getValue());
          name = name.replace(replacement.getKey(), replacement.getValue());
        }
        files.add(write(folder, name, content));
      }
    }
    assertEquals(Set.of(), missing, "texts that the doubles do not have");
    return compile(folder, files);
  }

  /** Compiles a source that may use the doubles, and returns the folder of the classes. */
  static Path compile(Path folder, String name, String source) throws IOException {
    return compile(folder, List.of(write(folder, name, source)));
  }

  private static String write(Path folder, String name, String source) throws IOException {
    Path file = folder.resolve("sources").resolve(name);
    Files.createDirectories(file.getParent());
    return Files.writeString(file, source).toString();
  }

  private static Path compile(Path folder, List<String> files) throws IOException {
    Path classes = folder.resolve("classes");
    List<String> arguments = new ArrayList<>(List.of("-nowarn", "-proc:none"));
    arguments.addAll(List.of("-d", classes.toString(), "-cp", CamSimRun.DOUBLES.toString()));
    arguments.addAll(files);
    int exit =
        ToolProvider.getSystemJavaCompiler()
            .run(null, null, null, arguments.toArray(String[]::new));
    assertEquals(0, exit);
    return classes;
  }
}
