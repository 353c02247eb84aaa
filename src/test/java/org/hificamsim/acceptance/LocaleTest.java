package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The same bytes under every locale: with a decimal comma, and with digits of its own. */
class LocaleTest {
  private static final List<String> LOCALES = List.of("en-US", "de-DE", "ar-EG");
  private static final List<String> OF_A_MOMENT =
      List.of("manifest.json", "ro-crate-metadata.json"); // times differ

  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(
      strings = {
        "run SCENARIOS/ring-random.xml --record --steps 30 --repeat 2 --out out",
        "compare SCENARIOS/ring-random.xml --steps 30 --repeat 2 --out out",
        "reproduce --steps 20 --repeat 2 --out out",
        "sensitivity --steps 20 --repeat 2 --out out",
        "camsim SCENARIOS/tutorial-camsim.xml -t 50 --extra-out extra.csv --coverage-out out",
        "generate out.xml --cameras 12"
      })
  void commandsPrintAndWriteTheSame(String command) throws Exception {
    assertSame(command.replace("SCENARIOS", Cli.ROOT.resolve("scenarios").toString()));
  }

  @Test
  void modelsFittedToPhotosAreTheSame() throws Exception {
    Path lab =
        Cli.lab(
            folder,
            "--scale 0.1 --objects 4 --focal-lengths 0.010,0.035,0.085 --distances 1,2,4,8");
    assertEquals(0, Cli.run("profile", "measure", lab).exit());
    for (String locale : LOCALES) {
      Path copy = Files.createDirectories(folder.resolve(locale).resolve("lab"));
      for (String file : List.of("camera.json", "measurements.csv")) {
        Files.copy(lab.resolve(file), copy.resolve(file));
      }
    }
    assertSame("profile fit lab --population 60 --generations 3");
  }

  private void assertSame(String command) throws Exception {
    List<String> said = new ArrayList<>();
    for (String locale : LOCALES) {
      said.add(run(locale, command));
      assertEquals(said.get(0), said.get(said.size() - 1), locale);
      assertSameFiles(folder.resolve(LOCALES.get(0)), folder.resolve(locale));
    }
  }

  /** Runs a command in a folder of the locale's own and returns what it printed. */
  private String run(String locale, String command) throws Exception {
    Path own = Files.createDirectories(folder.resolve(locale));
    List<String> options =
        List.of(
            "-Duser.language=" + locale.substring(0, 2), "-Duser.country=" + locale.substring(3));
    Process process =
        Java.main(
            own, options, System.getProperty("java.class.path"), (Object[]) command.split(" "));
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), said);
    return said.replaceAll("(?m)^.* left$\n", ""); // progress, on a slow machine
  }

  private static void assertSameFiles(Path expected, Path actual) throws IOException {
    List<Path> files = files(expected);
    assertTrue(files.size() > 0);
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
