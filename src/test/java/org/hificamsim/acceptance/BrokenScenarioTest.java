package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.hificamsim.core.AllocatedBytes;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests that broken scenarios end commands with exit code 2 and one line, which names file, line,
 * column, value and expectation, and write no output.
 */
class BrokenScenarioTest {
  private static final String SECRET = "canary-7f3a91";
  private static final long MEGABYTE = 1 << 20;

  @TempDir Path folder;

  @Test
  void originalScenarioIsValid() throws IOException {
    Path file = Files.writeString(folder.resolve("sound.xml"), BrokenScenario.SOUND);
    assertEquals(0, Cli.run("validate", file).exit());
    Cli run = Cli.run("run", file, "--steps", 20, "--out", folder.resolve("out"));
    assertEquals(0, run.exit(), run.err());
  }

  @TestFactory
  Stream<DynamicTest> rejectsEachScenarioInOneLineWithPlaceOfFault() throws IOException {
    return all().stream()
        .map(broken -> DynamicTest.dynamicTest(broken.name(), () -> check(broken)));
  }

  @Test
  void brokenScenariosAreSixtyOrMoreAndDiffer() throws IOException {
    Set<String> contents = new HashSet<>();
    for (BrokenScenario broken : all()) {
      assertTrue(
          contents.add(new String(broken.content(), StandardCharsets.ISO_8859_1)), broken.name());
    }
    assertTrue(contents.size() >= 60, contents.size() + " broken files");
  }

  @Test
  void rejectsMissingFile() {
    Path file = folder.resolve("no.xml");
    assertRejected(file, file + ":1:1: no such file, expected a file");
  }

  @ParameterizedTest
  @CsvSource({
    "(?s)<camera .*?/>|<event[^>]*camera.*?/>, 'no <camera>, expected at least one'",
    "'(?s)<objects>.*</objects>|<events>.*</events>',"
        + " 'no <object>, no <tracks> and no event that adds one, expected at least one target'"
  })
  void rejectsRunOfSite(String missing, String message) throws IOException {
    Path file = folder.resolve("site.xml");
    Files.writeString(file, BrokenScenario.SOUND.replaceAll(missing, ""));
    Path out = folder.resolve("out");
    Cli.run("run", file, "--out", out).assertRejected(message, out);
    Cli validate = Cli.run("validate", file);
    assertEquals(0, validate.exit(), validate.err());
    assertTrue(validate.err().contains(message + " for a run; place "), validate.err());
  }

  @Test
  void rejectsFolder() {
    assertRejected(folder, folder + ":1:1: is a folder, expected a file");
  }

  @Test
  void rejectsHundredMegabytesQuicklyWithLittleMemory() throws IOException {
    Path file = nested(100 * MEGABYTE);
    long bytes =
        assertTimeoutPreemptively(
            Duration.ofSeconds(60),
            () ->
                AllocatedBytes.by(
                    () ->
                        assertRejected(
                            file,
                            file + ":1:1: the file is too big, expected at most 67108864 bytes")));
    assertTrue(bytes < 64 * MEGABYTE, bytes + " bytes");
  }

  @Test
  void rejectsDeepNestingQuicklyWithLittleMemory() throws IOException {
    Path file = nested(60 * MEGABYTE);
    String message = ":1:97: <a> is nested too deep, expected at most 32 levels";
    long bytes =
        assertTimeoutPreemptively(
            Duration.ofSeconds(60),
            () -> AllocatedBytes.by(() -> assertRejected(file, file + message)));
    assertTrue(bytes < 800 * MEGABYTE, bytes + " bytes");
  }

  private List<BrokenScenario> all() throws IOException {
    return BrokenScenarios.all(Files.writeString(folder.resolve("canary.txt"), SECRET));
  }

  private void check(BrokenScenario broken) throws IOException {
    Path file = Files.write(folder.resolve("broken.xml"), broken.content());
    String place = file + ":" + broken.line() + ":" + broken.column() + ": ";
    assertRejected(file, place + broken.message());
  }

  private void assertRejected(Path file, String message) {
    Path out = folder.resolve("out");
    Cli run = Cli.run("run", file, "--out", out);
    assertEquals("error: " + message, last(run.err()));
    assertEquals(2, run.exit());
    assertEquals("", run.out());
    assertFalse(Files.exists(out), "nothing is written");
    assertPlain(run.err());
    Cli validate = Cli.run("validate", file);
    assertEquals("error: " + message, last(validate.err()));
    assertEquals(2, validate.exit());
    assertEquals("", validate.out());
    assertPlain(validate.err());
  }

  /** Checks for warnings and one error, without stack traces or content of the canary. */
  private static void assertPlain(String err) {
    List<String> lines = err.lines().toList();
    for (String line : lines.subList(0, lines.size() - 1)) {
      assertTrue(line.startsWith("warning: "), err);
    }
    assertFalse(err.contains("Exception") || err.contains("\tat ") || err.contains(SECRET), err);
  }

  private static String last(String text) {
    List<String> lines = text.lines().toList();
    return lines.isEmpty() ? "" : lines.get(lines.size() - 1);
  }

  private Path nested(long size) throws IOException {
    byte[] block = "<a>".repeat(1 << 18).getBytes(StandardCharsets.UTF_8);
    Path file = folder.resolve("nested.xml");
    try (OutputStream out = Files.newOutputStream(file)) {
      for (long written = 0; written < size; written += block.length) {
        out.write(block);
      }
    }
    return file;
  }
}
