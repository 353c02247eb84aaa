package org.hificamsim.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.ToolProvider;

/** Sources compiled for a test: another version of CamSim, or what else is on its class path. */
final class Variant {
  private static final Path SOURCES = CamSimRun.ROOT.resolve("camsim-bridge/src/doubles/java");

  private Variant() {}

  /** The doubles with a text replaced, in names of files too, as a folder of classes. */
  static Path of(Path folder, String text, String replacement) throws IOException {
    List<String> files = new ArrayList<>();
    boolean replaced = false;
    try (Stream<Path> sources = Files.walk(SOURCES)) {
      for (Path source : sources.filter(Files::isRegularFile).toList()) {
        String before = Files.readString(source);
        String after = before.replace(text, replacement);
        replaced |= !after.equals(before);
        String name = SOURCES.relativize(source).toString().replace(text, replacement);
        files.add(write(folder, name, after));
      }
    }
    assertTrue(replaced, "the doubles have no '" + text + "'");
    return compile(folder, files);
  }

  /** One source, which may use the doubles, as a folder of classes. */
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
