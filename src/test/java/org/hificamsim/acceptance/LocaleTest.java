package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.cli.Main;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Tests that every locale gives the same bytes. A locale with its own decimal sign and digits shows
 * all faults that a decimal comma would show.
 */
class LocaleTest {
  private static final List<String> LOCALES = List.of("en-US", "ar-EG");
  private static final List<String> OF_A_MOMENT =
      List.of("manifest.json", "ro-crate-metadata.json", ".hificamsim.sha256"); // times differ

  /** The commands, each of which writes into the folder that its first word names. */
  private static final List<String> COMMANDS =
      List.of(
          "run SCENARIOS/ring-random.xml --record --steps 30 --repeat 2 --out run",
          "compare SCENARIOS/ring-random.xml --steps 30 --repeat 2 --out compare",
          "reproduce --steps 20 --repeat 2 --out reproduce",
          "sensitivity --steps 20 --repeat 2 --out sensitivity",
          "camsim SCENARIOS/tutorial-camsim.xml -t 50 --coverage-out camsim/coverage",
          "generate generate/out.xml --cameras 12",
          "profile fit profile/lab --population 60 --generations 1");

  @TempDir static Path folder;

  /** Runs the commands in a process for each locale. */
  @BeforeAll
  static void runAllCommandsUnderEachLocale() throws Exception {
    Path lab =
        Cli.lab(folder, "--scale 0.05 --objects 3 --focal-lengths 0.010,0.035 --distances 1,2,4,8");
    assertEquals(0, Cli.run("profile", "measure", lab).exit());
    for (String locale : LOCALES) {
      Path own = folder.resolve(locale);
      for (String command : COMMANDS) {
        Files.createDirectories(own.resolve(name(command)));
      }
      Path copy = Files.createDirectories(own.resolve("profile/lab"));
      for (String file : List.of("camera.json", "measurements.csv")) {
        Files.copy(lab.resolve(file), copy.resolve(file));
      }
      run(locale, own);
    }
  }

  private static void run(String locale, Path own) throws Exception {
    List<String> options =
        List.of(
            "-Duser.language=" + locale.substring(0, 2), "-Duser.country=" + locale.substring(3));
    String scenarios = Cli.ROOT.resolve("scenarios").toAbsolutePath().toString();
    Object[] words =
        COMMANDS.stream().map(command -> command.replace("SCENARIOS", scenarios)).toArray();
    Process process =
        Java.start(
            own, options, System.getProperty("java.class.path"), LocaleTest.class.getName(), words);
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), output);
  }

  /** Runs each word as a command, and writes its output into the folder of its files. */
  public static void main(String[] commands) throws IOException {
    for (String command : commands) {
      StringWriter output = new StringWriter();
      PrintWriter writer = new PrintWriter(output, true);
      int exit = Main.execute(writer, writer, command.split(" "));
      assertEquals(0, exit, command + ": " + output);
      Files.writeString(
          Path.of(name(command), "said.txt"),
          output.toString().replaceAll("(?m)^.* left$\n", "")); // progress, on a slow machine
    }
  }

  static Stream<String> everyLocaleGivesSameOutput() {
    return COMMANDS.stream().map(LocaleTest::name);
  }

  @ParameterizedTest
  @MethodSource
  void everyLocaleGivesSameOutput(String name) throws IOException {
    Path expected = folder.resolve(LOCALES.get(0)).resolve(name);
    for (String locale : LOCALES.subList(1, LOCALES.size())) {
      assertSameFiles(expected, folder.resolve(locale).resolve(name));
    }
  }

  private static String name(String command) {
    return command.substring(0, command.indexOf(' '));
  }

  private static void assertSameFiles(Path expected, Path actual) throws IOException {
    List<Path> files = files(expected);
    assertTrue(files.size() > 1, files.toString());
    assertEquals(files, files(actual));
    for (Path file : files) {
      if (!OF_A_MOMENT.contains(file.getFileName().toString())) {
        assertArrayEquals(
            Files.readAllBytes(expected.resolve(file)),
            Files.readAllBytes(actual.resolve(file)),
            actual.resolve(file).toString());
      }
    }
  }

  private static List<Path> files(Path folder) throws IOException {
    try (Stream<Path> all = Files.walk(folder)) {
      return all.filter(Files::isRegularFile).map(folder::relativize).sorted().toList();
    }
  }
}
