package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;
import javax.tools.ToolProvider;

/**
 * An extension in {@code examples/}, compiled and packed into a jar as its author would do it.
 *
 * @param jar the jar with the classes and the service file
 */
record Example(Path jar) {
  /** Compiles {@code examples/NAME/src}. */
  static Example pack(String name, Path folder) throws IOException {
    Path source = Cli.ROOT.resolve("examples").resolve(name).resolve("src");
    Path classes = Files.createDirectories(folder.resolve(name));
    List<String> arguments = new ArrayList<>(List.of("-d", classes.toString(), "-cp"));
    arguments.add(System.getProperty("java.class.path"));
    files(source)
        .filter(file -> file.toString().endsWith(".java"))
        .forEach(file -> arguments.add(file.toString()));
    assertEquals(
        0,
        ToolProvider.getSystemJavaCompiler()
            .run(null, null, null, arguments.toArray(String[]::new)));
    Path jar = folder.resolve(name + ".jar");
    try (OutputStream stream = Files.newOutputStream(jar);
        JarOutputStream out = new JarOutputStream(stream)) {
      add(out, classes, files(classes).toList());
      add(out, source, files(source.resolve("META-INF")).toList());
    }
    return new Example(jar);
  }

  /** Runs the command line with this jar added to its class path. */
  Cli run(Object... words) throws IOException, InterruptedException {
    Process process =
        Java.main(System.getProperty("java.class.path") + File.pathSeparator + jar, words);
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    return new Cli(process.waitFor(), output, output);
  }

  private static Stream<Path> files(Path folder) throws IOException {
    try (Stream<Path> all = Files.walk(folder)) {
      return all.filter(Files::isRegularFile).sorted().toList().stream();
    }
  }

  private static void add(JarOutputStream out, Path root, List<Path> files) throws IOException {
    for (Path file : files) {
      out.putNextEntry(new JarEntry(root.relativize(file).toString()));
      Files.copy(file, out);
      out.closeEntry();
    }
  }
}
