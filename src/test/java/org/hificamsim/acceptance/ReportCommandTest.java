package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests what {@code report} writes and rejects. */
class ReportCommandTest {
  @TempDir Path folder;

  @Test
  void makesSamePageFromFolder() throws IOException {
    Path scenario = Files.copy(Cli.scenario("ring-random"), folder.resolve("gone.xml"));
    Path run = folder.resolve("run");
    Cli.run("run", scenario, "--steps", 30, "--record", "--out", run);
    Files.delete(scenario);
    Path moved = Files.move(run, folder.resolve("moved"));
    Path page = folder.resolve("page.html");
    Cli report = Cli.run("report", moved, "--out", page);
    assertEquals(0, report.exit(), report.err());
    assertEquals(page + "\n", report.out());
    assertArrayEquals(Files.readAllBytes(moved.resolve("report.html")), Files.readAllBytes(page));
  }

  @Test
  void deletesPageAfterRunWithoutRecord() {
    Path run = record();
    assertTrue(Files.exists(run.resolve("report.html")));
    Cli.run("run", Cli.scenario("ring-random"), "--steps", 30, "--out", run);
    assertFalse(Files.exists(run.resolve("report.html")));
    assertRejected(run, "replay.json");
  }

  @Test
  void rejectsTablesWithoutScoresOrSteps() throws IOException {
    Path run = record();
    Path steps = run.resolve("steps.csv");
    List<String> rows = Files.readAllLines(steps);
    Files.write(steps, rows.subList(0, rows.size() - 1));
    assertRejected(run, "no row for run,step 0,29");
    Files.write(steps, rows);
    Path summary = run.resolve("summary.json");
    Files.writeString(summary, Files.readString(summary).replace("score_words", "words"));
    assertRejected(run, "no score_words");
  }

  @ParameterizedTest
  @ValueSource(strings = {"replay.json", "steps.csv", "summary.json", "manifest.json"})
  void reportsMissingFile(String name) throws IOException {
    Path run = record();
    Files.delete(run.resolve(name));
    assertRejected(run, name);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "steps.csv | (?m)^(0,7,.*),[0-9.]+$ | $1,x | ,x' is no row, expected"
            + " run,step,k_min,...,score, numbers",
        "summary.json | \\{ | [[ | not JSON",
        "summary.json | epsilon-greedy | sarsa | policy is 'sarsa', but replay.json says"
            + " 'epsilon-greedy'",
        "replay.json | \"x\":[0-9.e-]+ | \"x\":[] | replay.json:1:",
        "replay.json | \"data\":\"....... | \"data\":\"eJx?AAA | run 0",
        "replay.json | \"frames\":30 | \"frames\":-1 | frames of run 0",
        "replay.json | replay-1 | replay-9 | format is 'hificamsim-replay-9'",
      })
  void reportsEditedFileInOneLine(String name, String from, String to, String expected)
      throws IOException {
    Path run = record();
    Path file = run.resolve(name);
    String before = Files.readString(file);
    String after = before.replaceFirst(from, to);
    assertFalse(before.equals(after));
    Files.writeString(file, after);
    assertRejected(run, expected);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "summary.csv | scenario,detection | site,detection | summary.csv:1:1: the columns are"
            + " site,",
        "settings.json | \\[ | < | settings.json:1:1: not JSON",
      })
  void reportsEditedComparisonInOneLine(String name, String from, String to, String expected)
      throws IOException {
    Path out = folder.resolve("compared");
    Cli.run(
        "compare",
        Cli.scenario("ring-random"),
        "--detections",
        "hifi:orb-lin",
        "--policies",
        "zoom-out",
        "--steps",
        20,
        "--repeat",
        2,
        "--out",
        out);
    Path file = out.resolve(name);
    String before = Files.readString(file);
    Files.writeString(file, before.replaceFirst(from, to));
    assertFalse(before.equals(Files.readString(file)));
    assertRejected(out, expected);
  }

  @ParameterizedTest
  @CsvSource({
    "steps.csv, '(?m)^0,7,[0-9]+', '0,7,99'",
    "replay.json, '\"repeat\":1', '\"repeat\":2'"
  })
  void warnsOfEditedFiles(String name, String from, String to) throws IOException {
    Path run = record();
    Path file = run.resolve(name);
    String before = Files.readString(file);
    Files.writeString(file, before.replaceFirst(from, to));
    assertFalse(before.equals(Files.readString(file)));
    Cli report = Cli.run("report", run);
    assertEquals(0, report.exit(), report.err());
    assertEquals(
        "warning: '%s': not as it was written: %s (.hificamsim.sha256)%n".formatted(run, name),
        report.err());
  }

  @Test
  void rejectsMissingFoldersAndUnwritableOutputs() {
    assertRejected(folder.resolve("nowhere"), "no folder");
    assertRejected(folder, "replay.json");
    Path run = record();
    Cli report = Cli.run("report", run, "--out", folder.resolve("missing/page.html"));
    assertEquals(2, report.exit());
    assertTrue(report.err().contains("--out"), report.err());
  }

  @ParameterizedTest
  @CsvSource({
    "--run, '--png, --svg, --pdf or --gif', ",
    "--step, '--png, --svg or --pdf', --gif",
    "--from, --gif, --png",
    "--to, --gif, --svg",
    "--every, --gif, --png",
    "--per-second, --gif, ",
    "--width, --png or --gif, --svg"
  })
  void rejectsOptionsOfPicturesWithoutPicture(String option, String needed, String given) {
    List<Object> words = new ArrayList<>(List.of("report", record(), option, 5));
    if (given != null) {
      words.addAll(List.of(given, folder.resolve("picture")));
    }
    Cli report = Cli.run(words.toArray());
    assertEquals(2, report.exit());
    assertEquals("error: " + option + " needs " + needed + "\n", report.err());
    assertFalse(Files.exists(folder.resolve("picture")));
  }

  private Path record() {
    Path run = folder.resolve("recorded");
    Cli cli = Cli.run("run", Cli.scenario("ring-random"), "--steps", 30, "--record", "--out", run);
    assertEquals(0, cli.exit(), cli.err());
    return run;
  }

  private static void assertRejected(Path run, String expected) {
    Cli report = Cli.run("report", run);
    assertEquals(2, report.exit(), report.err());
    assertEquals(1, report.err().lines().count(), report.err());
    assertTrue(report.err().startsWith("error: "), report.err());
    assertTrue(report.err().contains(expected), report.err());
  }
}
