package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.cli.Main;

/**
 * The outcome of a command.
 *
 * @param exit the exit code
 */
record Cli(int exit, String out, String err) {
  /** The project's root. */
  static final Path ROOT = Path.of(System.getProperty("hificamsim.root", "."));

  /** The scenarios of Table 7.1, by name. */
  static final List<String> SIX =
      Stream.of("lattice", "ring", "cluster")
          .flatMap(layout -> Stream.of(layout + "-random", layout + "-scripted"))
          .toList();

  /** Runs a command in this process. */
  static Cli run(Object... words) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    String[] args = Arrays.stream(words).map(Object::toString).toArray(String[]::new);
    int exit = Main.execute(new PrintWriter(out, true), new PrintWriter(err, true), args);
    return new Cli(exit, out.toString(), err.toString());
  }

  /** Returns the names of a folder's files, in order, without the record that commands keep. */
  static List<String> names(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> !name.equals(".hificamsim.sha256"))
          .sorted()
          .toList();
    }
  }

  /** Returns the content of a file, without a checked exception, so that streams can use it. */
  static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the file of a shipped scenario. */
  static Path scenario(String name) {
    return ROOT.resolve("scenarios").resolve(name + ".xml");
  }

  /**
   * Renders photos into a folder's {@code lab}, and returns it.
   *
   * @param options the options of {@code profile lab}, separated by blanks
   */
  static Path lab(Path folder, String options) {
    Path lab = folder.resolve("lab");
    Stream<Object> words = Stream.of("profile", "lab", "--out", lab);
    Cli rendered = run(Stream.concat(words, Stream.of(options.split(" "))).toArray());
    assertEquals(0, rendered.exit(), rendered.err());
    return lab;
  }

  /** Fails unless {@code validate} and {@code run} accept a scenario. */
  static void assertValidAndRuns(Path scenario, Path out) {
    Cli validate = run("validate", scenario);
    assertEquals(0, validate.exit(), validate.err());
    Cli run = run("run", scenario, "--detection", "camsim-visibility", "--steps", 20, "--out", out);
    assertEquals(0, run.exit(), run.err());
  }

  /**
   * Fails unless a command is rejected in one line with the expected text, and writes no folder.
   *
   * @param options the options, separated by blanks
   * @param before the words before the options
   */
  static void assertRejects(String options, String expected, Path folder, Object... before) {
    Stream<Object> words = Stream.concat(Stream.of(before), Stream.of("--out", folder));
    run(Stream.concat(words, Stream.of(options.strip().split(" "))).toArray())
        .assertRejected(expected, folder);
  }

  /** Fails unless the command was rejected in one line with the expected text, without a folder. */
  void assertRejected(String expected, Path folder) {
    assertEquals(2, exit, err);
    assertEquals(1, err.lines().count(), err);
    assertTrue(err.contains(expected), err);
    assertFalse(Files.exists(folder));
  }
}
