package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;

/** Tests that the detection, rule, objective and steps of a scenario apply without options. */
class ScenarioQuestionTest {
  private static final String CORRIDOR = "oodpcvs-2025:level=perceive";

  @TempDir Path folder;

  @ParameterizedTest
  @CsvFileSource(resources = "/org/hificamsim/acceptance/sites.csv")
  void sitesRunWithoutOptions(String name, String detection) throws IOException {
    Path out = folder.resolve("out");
    Cli run = Cli.run("run", Cli.scenario(name), "--out", out);
    assertEquals(0, run.exit(), run.err());
    JsonNode summary = json(out.resolve("summary.json"));
    assertEquals(detection, summary.path("detection").asText());
    assertEquals("scenario", summary.path("detection_from").asText());
    assertEquals("scenario", summary.path("objective_from").asText());
    assertEquals("scenario", summary.path("steps_from").asText());
    double mean = summary.path("score").asDouble() / summary.path("steps").asInt();
    boolean share = summary.path("score_unit").asText().equals("share");
    String shown =
        String.format(Locale.ROOT, share ? "%.1f %%" : "%.3f", share ? 100 * mean : mean);
    assertTrue(mean > 0, name);
    String words = summary.path("score_words").asText() + (share ? "" : ", mean of the steps");
    assertTrue(run.out().startsWith("score            " + words + ": " + shown), run.out());
  }

  @Test
  void optionOverridesScenarioAndScenarioOverridesDefault() throws IOException {
    Path bare = scenario("");
    Path withAttributes = scenario("detection=\"geometric\" detect=\"threshold\" steps=\"7\"");
    assertPlan("hifi:orb-lin 1000 default default default", summary("run", bare));
    assertPlan("geometric 7 scenario scenario scenario", summary("run", withAttributes));
    assertPlan(
        "camsim-range 3 option scenario option",
        summary("run", withAttributes, "--detection", "camsim-range", "--steps", 3));
    Cli withDetection =
        Cli.run("run", withAttributes, "--steps", 3, "--out", folder.resolve("told"));
    assertTrue(
        withDetection
            .out()
            .contains("option: steps; scenario: detection, detect; default: objective"),
        withDetection.out());
  }

  @Test
  void thresholdOfScenarioAppliesToItsDetectionOnly() throws IOException {
    Path with = scenario("detection=\"camsim-range@0.6\"");
    Path next = scenario("detection=\"camsim-range\" threshold=\"0.6\"");
    for (Path file : List.of(with, next)) {
      assertEquals(0.6, threshold(file));
      assertEquals(0.35, threshold(file, "--detection", "camsim-standard"));
      assertEquals(0.7, threshold(file, "--threshold", "0.7"));
    }
    assertEquals(0.6, threshold(scenario("threshold=\"0.6\""), "--detection", "camsim-standard"));
  }

  @Test
  void ruleOptionOverridesRuleOfScenario() throws IOException {
    Path file = scenario("detection=\"hifi:orb-lin@0.1\"");
    JsonNode summary = summary("run", file, "--detect", "chance", "--steps", 2);
    assertEquals("chance", summary.path("detect").asText());
    assertEquals("option", summary.path("detect_from").asText());
    assertFalse(summary("run", file, "--steps", 2).has("detect"), "by a threshold");
  }

  @Test
  void findsModelFileNextToScenarioAndResults() throws IOException {
    Cli.run("run", scenario(""), "--steps", 1, "--out", folder.resolve("model"));
    Path model = Files.createDirectories(folder.resolve("models")).resolve("own.json");
    Files.copy(folder.resolve("model").resolve("detection-hifi-orb-lin.json"), model);
    Path file = scenario("detection=\"../models/own.json@0.2\" steps=\"40\"");
    JsonNode first = summary("run", file);
    assertEquals(0.2, first.path("threshold").asDouble());
    Path copies = Files.move(folder.resolve("out"), folder.resolve("elsewhere"));
    Files.delete(model);
    JsonNode again = summary("run", copies.resolve("scenario-scenario.xml"));
    assertEquals(first.path("runs"), again.path("runs"));
  }

  @Test
  void reportsPlaceOfUnknownDetection() throws IOException {
    Path file = scenario("detection=\"oodpcvs-2025:level=perceived\"");
    for (String command : List.of("run", "validate", "compare", "view")) {
      Cli refused = Cli.run(command, file);
      assertEquals(2, refused.exit(), command);
      assertEquals(1, refused.err().lines().count(), refused.err());
      assertTrue(refused.err().contains(file + ":3:"), refused.err());
      assertTrue(refused.err().contains("perceived"), refused.err());
    }
    assertEquals(0.5, threshold(file, "--detection", "geometric", "--steps", 1));
  }

  @Test
  void rejectsSecondThreshold() throws IOException {
    Cli refused = Cli.run("validate", scenario("detection=\"geometric@0.3\" threshold=\"0.4\""));
    assertEquals(2, refused.exit());
    assertTrue(refused.err().contains("threshold is '0.4', expected none"), refused.err());
  }

  @Test
  void compareUsesDetectionOfEachScenario() throws IOException {
    Path out = folder.resolve("out");
    String few = "--policies zoom-out --steps 3 --repeat 1 --out " + out;
    run("compare", Cli.scenario("corridor"), Cli.scenario("ring-random"), few);
    assertEquals(
        List.of("corridor " + CORRIDOR, "ring-random camsim-range", "ring-random hifi:orb-lin"),
        cases(out));
    run("compare", Cli.scenario("corridor"), few + "-2 --detections geometric");
    assertEquals(List.of("corridor geometric"), cases(Path.of(out + "-2")));
  }

  @Test
  void camsimUsesStepsAndDetectionOfScenario() throws IOException {
    Path file = scenario("detection=\"camsim-range\" steps=\"7\"");
    String files = "-o " + folder.resolve("c.csv") + " --coverage-out " + folder.resolve("out");
    run("camsim", file, files);
    JsonNode summary = json(folder.resolve("out").resolve("summary.json"));
    assertEquals("camsim-range", summary.path("detection").asText());
    assertEquals(7, summary.path("steps").asInt());
  }

  /** Writes a small scenario with these attributes of its simulation. */
  private Path scenario(String attributes) throws IOException {
    String text =
        """
<root>
  <simulation
    %s min_x="0" max_x="20" min_y="0" max_y="20">
    <cameras><camera name="a" x="10" y="10" heading="0" viewing_angle="360" range="8"/></cameras>
    <objects><object features="1" x="9" y="9" heading="45" speed="1"/></objects>
  </simulation>
</root>
""";
    Path file = Files.createTempDirectory(folder, "site").resolve("scenario.xml");
    return Files.writeString(file, text.formatted(attributes));
  }

  private JsonNode summary(Object... words) throws IOException {
    Path out = folder.resolve("out");
    run(Stream.concat(Arrays.stream(words), Stream.of("--out", out)).toArray());
    return json(out.resolve("summary.json"));
  }

  private static JsonNode json(Path file) throws IOException {
    return new ObjectMapper().readTree(file.toFile());
  }

  private double threshold(Path file, Object... options) throws IOException {
    List<Object> words = new ArrayList<>(List.of("run", file));
    words.addAll(List.of(options));
    return summary(words.toArray()).path("threshold").asDouble();
  }

  /** Runs a command, whose arguments may contain several words each. */
  private static void run(Object... words) {
    Cli done =
        Cli.run(
            Arrays.stream(words)
                .flatMap(word -> Arrays.stream(word.toString().split(" ")))
                .toArray());
    assertEquals(0, done.exit(), done.err());
  }

  private static void assertPlan(String expected, JsonNode summary) {
    List<String> fields =
        List.of("detection", "steps", "detection_from", "detect_from", "steps_from");
    assertEquals(
        expected,
        String.join(" ", fields.stream().map(field -> summary.path(field).asText()).toList()));
  }

  private static List<String> cases(Path out) throws IOException {
    return Files.readAllLines(out.resolve("results.csv")).stream()
        .skip(1)
        .map(line -> line.split(","))
        .filter(cells -> !cells[2].equals("optimal"))
        .map(cells -> cells[0] + " " + cells[1])
        .distinct()
        .toList();
  }
}
