package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.Reference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests {@code validate} and {@code list}. */
class ValidateAndListTest {
  @TempDir Path folder;

  @Test
  void shippedScenariosValidateWithoutWarnings() throws IOException {
    try (Stream<Path> files = Files.list(Cli.ROOT.resolve("scenarios"))) {
      for (Path file : files.filter(path -> path.toString().endsWith(".xml")).sorted().toList()) {
        Cli validate = Cli.run("validate", file);
        assertEquals(0, validate.exit(), validate.err());
        assertTrue(validate.out().startsWith(file + ": ok, "), validate.out());
        assertTrue(
            validate.err().lines().allMatch(ValidateAndListTest::isExpected), validate.err());
      }
    }
  }

  /** Whether a warning is about the default model, which was fitted indoors and up to 10 m. */
  private static boolean isExpected(String line) {
    return line.contains("/tutorial-")
        && (line.contains("(Eq 3.1)") || line.contains("was not fitted on what is asked of it"));
  }

  @Test
  void referenceFilesAreValidAndRun() {
    List<Path> scenarios =
        Stream.of("own-camsim", "own-coverage")
            .flatMap(name -> Reference.scenarios(name).stream())
            .toList();
    assertEquals(32, scenarios.size());
    scenarios.forEach(file -> Cli.assertValidAndRuns(file, folder));
  }

  @Test
  void checksRemainingFilesAfterInvalidOne() throws IOException {
    Path bad = Files.writeString(folder.resolve("bad.xml"), "<root/>");
    Cli validate =
        Cli.run("validate", bad, Cli.scenario("lattice-random"), Cli.scenario("ring-random"));
    assertEquals(2, validate.exit());
    assertEquals(2, validate.out().lines().count());
    assertTrue(validate.err().startsWith("error: " + bad + ":1:1: "), validate.err());
  }

  /** A scenario with five faults and one that follows from them: there is no camera named a. */
  private static final String FIVE_FAULTS =
      """
      <root>
        <simulation min_x="0" max_x="9" min_y="0" max_y="9" order="never" threshold="2">
          <cameras>
            <zoom>1 2</zoom>
            <camera name="a" x="99" y="1" heading="0" viewing_angle="90" range="1"/>
            <camera name="b" x="1" y="1" heading="0" viewing_angle="90" range="1" lens="7"/>
          </cameras>
          <objects>
            <object features="1" x="1" y="1" heading="0" speed="fast"/>
            <object features="2" x="1" y="1" heading="0" speed="1"/>
          </objects>
          <events>
            <event timestep="1" participant="camera" event="error" name="a"/>
          </events>
        </simulation>
      </root>
      """;

  @Test
  void reportsAllIndependentFaults() throws IOException {
    Path bad = Files.writeString(folder.resolve("bad.xml"), FIVE_FAULTS);
    Cli validate = Cli.run("validate", bad);
    assertEquals(2, validate.exit());
    assertEquals("", validate.out());
    String[] starts = {
      "warning: " + bad + ":6:77: unknown attribute lens",
      "error: " + bad + ":2:55: <simulation> order is 'never', expected one of",
      "error: " + bad + ":2:69: <simulation> threshold is '2', expected a number from 0 to 1",
      "error: " + bad + ":5:24: <camera> x is '99', expected a number inside the field",
      "error: " + bad + ":9:52: <object> speed is 'fast', expected a number",
      "error: " + bad + ":13:7: <event> has no duration, expected a whole number"
    };
    List<String> lines = validate.err().lines().toList();
    assertEquals(starts.length, lines.size(), validate.err());
    for (int i = 0; i < starts.length; i++) {
      assertTrue(lines.get(i).startsWith(starts[i]), lines.get(i));
    }
  }

  @Test
  void runReportsOnlyTheFirstFault() throws IOException {
    Path bad = Files.writeString(folder.resolve("bad.xml"), FIVE_FAULTS);
    Cli run = Cli.run("run", bad);
    assertEquals(2, run.exit());
    assertEquals(1, run.err().lines().count(), run.err());
  }

  @Test
  void reportsAtMostOneHundredFaults() throws IOException {
    String camera = "<camera name=\"\" x=\"99\"/>\n";
    Path bad =
        Files.writeString(
            folder.resolve("bad.xml"),
            "<root><simulation min_x='0' max_x='9' min_y='0' max_y='9'/>"
                + camera.repeat(250)
                + "</root>");
    List<String> lines = Cli.run("validate", bad).err().lines().toList();
    assertEquals(101, lines.size());
    assertEquals("error: " + bad + ": 150 more, expected none", lines.get(100));
  }

  @ParameterizedTest
  @ValueSource(strings = {"validate", "run --steps 5 --out", "compare --steps 5 --repeat 1 --out"})
  void strictTurnsWarningsIntoErrors(String words) throws IOException {
    Path out = folder.resolve("out");
    Path odd =
        Files.writeString(
            folder.resolve("odd.xml"),
            Files.readString(Cli.scenario("ring-random"))
                .replace("<simulation ", "<simulation lens='7' "));
    String[] command = (words + (words.endsWith("out") ? " " + out : "")).split(" ");
    List<Object> all = new ArrayList<>(List.of((Object[]) command));
    all.add(odd);
    Cli lenient = Cli.run(all.toArray());
    assertEquals(0, lenient.exit(), lenient.err());
    assertTrue(lenient.err().startsWith("warning: " + odd + ":"), lenient.err());
    all.add("--strict");
    Cli strict = Cli.run(all.toArray());
    assertEquals(2, strict.exit());
    assertEquals("", strict.out());
    assertEquals(
        "error: "
            + lenient.err().lines().findFirst().orElseThrow().substring("warning: ".length())
            + "; expected no warning, with --strict",
        strict.err().strip());
  }

  @Test
  void explainsThresholdsAndOptions() {
    List<String> models = Cli.run("list", "detections").out().lines().toList();
    assertTrue(models.get(0).contains(" (threshold "), models.get(0));
    assertTrue(models.get(models.size() - 1).endsWith("See docs/detection.md."));
    List<String> policies = Cli.run("list", "policies").out().lines().toList();
    int greedy =
        policies.indexOf(
            policies.stream()
                .filter(line -> line.startsWith("epsilon-greedy "))
                .findFirst()
                .orElseThrow());
    assertTrue(policies.get(greedy + 1).startsWith("    epsilon=0.1  "), policies.get(greedy + 1));
    assertTrue(Cli.run("list", "scenarios").out().contains("ring-random.xml"));
  }

  @Test
  void jsonPrintsSummaryOfRun() throws IOException {
    Cli run = Cli.run("run", Cli.scenario("ring-random"), "--steps", 5, "--json", "--out", folder);
    assertEquals(0, run.exit(), run.err());
    assertEquals(Files.readString(folder.resolve("summary.json")), run.out());
  }

  @ParameterizedTest
  @ValueSource(strings = {"hifi:orb-lin", "camsim-range", "hifi-literal", "geometric"})
  void listsDetections(String name) {
    Cli list = Cli.run("list", "detections");
    assertEquals(0, list.exit());
    assertTrue(list.out().lines().anyMatch(line -> line.startsWith(name + " ")), list.out());
  }

  @Test
  void listsPoliciesWithTheirOptions() {
    Cli list = Cli.run("list", "policies");
    assertEquals(0, list.exit());
    assertTrue(list.out().contains("epsilon-greedy"), list.out());
    assertTrue(list.out().contains("    epsilon=0.1"), list.out());
  }

  @Test
  void listsWhichPoliciesAreBounds() {
    List<String> bounds =
        Cli.run("list", "policies")
            .out()
            .lines()
            .filter(line -> line.matches("\\S+ +bound: .*"))
            .map(line -> line.replaceFirst(" .*", ""))
            .toList();
    assertEquals(
        List.of(
            "independent-greedy",
            "optimal",
            "bound",
            "optimal-expected",
            "one-hop",
            "best-fixed",
            "reachable"),
        bounds);
  }

  @Test
  void listsScenarios() {
    Cli list = Cli.run("list", "scenarios");
    assertEquals(0, list.exit(), list.err());
    Cli.SIX.forEach(name -> assertTrue(list.out().contains(name + ".xml"), name));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "run",
        "compare",
        "validate",
        "list",
        "list detections",
        "list policies",
        "list scenarios"
      })
  void everyCommandHasHelp(String words) {
    Cli help = Cli.run((Object[]) (words + " --help").split(" "));
    assertEquals(0, help.exit(), help.err());
    assertTrue(help.out().startsWith("Usage: hificamsim " + words), help.out());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "rnu x.xml | unknown command 'rnu', expected one of run, ",
        "list detction | unknown command 'detction', expected one of detections, policies,"
            + " scenarios",
        "profile | expected lab, measure, fit",
        "run --stepz 3 | Unknown option: '--stepz', maybe --strict or --steps",
      })
  void suggestsCorrectionOfMisspelledWord(String words, String expected) {
    Cli wrong = Cli.run((Object[]) words.split(" "));
    assertEquals(2, wrong.exit());
    assertEquals(1, wrong.err().lines().count(), wrong.err());
    assertTrue(wrong.err().contains(expected), wrong.err());
  }

  @Test
  void printsHelpAndCompletionScript() {
    assertTrue(Cli.run("help", "run").out().startsWith("Usage: hificamsim run "));
    assertTrue(Cli.run("generate-completion").out().startsWith("#!/usr/bin/env bash"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "list", "walk", "list nothing", "run"})
  void rejectsInvalidCommandsInOneLine(String words) {
    Cli wrong = words.isEmpty() ? Cli.run() : Cli.run((Object[]) words.split(" "));
    assertEquals(2, wrong.exit());
    assertEquals(1, wrong.err().lines().count(), wrong.err());
    assertTrue(wrong.err().startsWith("error: "), wrong.err());
  }
}
