package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests {@code --detect}: a rule has the same results in all commands and in the scenario. */
class ChanceTest {
  private static final Path LATTICE = Cli.scenario("lattice-random");

  @TempDir Path folder;

  @Test
  void onlyChanceDistinguishesDetectorsOfOneAbstraction() throws IOException {
    for (String rule : List.of("threshold", "chance")) {
      String orb = steps("hifi:orb-lin", rule);
      boolean same = rule.equals("threshold");
      assertEquals(same, orb.equals(steps("hifi:sift-lin", rule)), rule);
      assertEquals(same, orb.equals(steps("hifi:surf-lin", rule)), rule);
      assertEquals(same, orb.equals(steps("hifi:orb-lin-gt", rule)), rule);
    }
  }

  private String steps(String detection, String rule) throws IOException {
    Path out = folder.resolve("out");
    Cli.run(
        "run",
        LATTICE,
        "--detection",
        detection,
        "--detect",
        rule,
        "--policy",
        "optimal",
        "--steps",
        200,
        "--out",
        out);
    return Files.readString(out.resolve("steps.csv"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"chance", "chance:alpha=0.01,memory=5,phantoms=on", "probability"})
  void scenarioMayNameTheRule(String rule) throws IOException {
    Path option = folder.resolve("option");
    Path attribute = folder.resolve("attribute");
    Path file =
        Files.writeString(
            folder.resolve("lattice-random.xml"),
            Files.readString(LATTICE)
                .replaceFirst("<simulation", "<simulation detect=\"" + rule + "\""));
    run("run", LATTICE, "--detect", rule, "--record", "--steps", 100, "--out", option);
    run("run", file, "--record", "--steps", 100, "--out", attribute);
    for (String name : List.of("steps.csv", "zooms.csv", "targets.csv", "summary.json")) {
      assertEquals(
          Files.readString(option.resolve(name)),
          Files.readString(attribute.resolve(name))
              .replace("\"detect_from\" : \"scenario\"", "\"detect_from\" : \"option\""),
          name);
    }
    JsonNode summary = new ObjectMapper().readTree(option.resolve("summary.json").toFile());
    assertEquals(rule, summary.get("detect").asText());
    assertEquals("hifi:orb-lin@" + rule.replace(',', ';'), summary.get("detection").asText());
    run("run", file, "--detect", "threshold", "--steps", 100, "--out", attribute);
    run("run", LATTICE, "--steps", 100, "--out", option);
    assertEquals(
        Files.readString(option.resolve("steps.csv")),
        Files.readString(attribute.resolve("steps.csv")),
        "the option goes before the scenario");
  }

  @Test
  void writesExpectedNextToDrawnCoverage() throws IOException {
    Path out = folder.resolve("out");
    run("run", LATTICE, "--detect", "chance", "--record", "--steps", 3000, "--out", out);
    List<String> steps = Files.readAllLines(out.resolve("steps.csv"));
    assertEquals(
        "run,step,k_min,targets,covered_0,covered_1,covered_k,mean_k,expected_k_min,"
            + "expected_covered_0,expected_covered_1,expected_covered_k,expected_mean_k,"
            + "least_expected_k,least_chance,score",
        steps.get(0));
    assertTrue(
        Files.readAllLines(out.resolve("targets.csv")).get(0).endsWith("x,y,k,chance_1,chance_k"));
    JsonNode summary = new ObjectMapper().readTree(out.resolve("summary.json").toFile());
    for (String share : List.of("covered_0", "covered_1", "covered_k")) {
      double drawn = summary.get(share).asDouble();
      assertEquals(summary.get("expected_" + share).asDouble(), drawn, 0.02, share);
    }
    double sum = 0;
    for (String row : steps.subList(1, steps.size())) {
      sum += Double.parseDouble(row.split(",")[8]);
    }
    assertEquals(sum, summary.get("expected_performance").asDouble(), 1e-9 * sum);
    assertEquals(0, Cli.run("report", out).exit());
    assertTrue(Files.readString(out.resolve("report.html")).contains("hifi:orb-lin@chance"));
  }

  /** Two cameras and a target 1.9 km away from both, for 2,000 steps. */
  @ParameterizedTest
  @ValueSource(strings = {"hifi:orb-lin", "hifi:sift-pinhole", "lab:orb-pinhole"})
  void neverCoversTargetBeyondReach(String model) throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("far.xml"),
            """
            <root><simulation min_x="0" max_x="4000" min_y="0" max_y="100"><zoom>2000 3000</zoom>
            <camera name="a" x="10" y="60" heading="0" viewing_angle="360" range="9"/>
            <camera name="b" x="20" y="60" heading="0" viewing_angle="360" range="9"/>
            <object features="1" x="1920" y="5" heading="0" speed="0"/>
            </simulation></root>
            """);
    Path out = folder.resolve("out");
    run("run", file, "--detection", model, "--detect", "chance", "--steps", 2000, "--out", out);
    JsonNode summary = new ObjectMapper().readTree(out.resolve("summary.json").toFile());
    assertEquals(1, summary.get("covered_0").asDouble());
    assertEquals(1, summary.get("expected_covered_0").asDouble(), 1e-4);
  }

  @Test
  void summaryHasNoExpectedValuesWithoutChance() throws IOException {
    Path out = folder.resolve("out");
    run("run", LATTICE, "--steps", 10, "--out", out);
    assertFalse(Files.readString(out.resolve("summary.json")).contains("expected"));
  }

  @Test
  void comparesRulesEquallyOnAnyNumberOfThreads() throws IOException {
    Path first = folder.resolve("one");
    Path second = folder.resolve("two");
    for (Path out : List.of(first, second)) {
      run(
          "compare",
          LATTICE,
          "--detections",
          "hifi:orb-lin,hifi:orb-lin@chance,hifi:orb-lin@chance:alpha=0.01;memory=9",
          "--policies",
          "zoom-out,sarsa",
          "--steps",
          200,
          "--repeat",
          2,
          "--threads",
          out.equals(first) ? 1 : 2,
          "--out",
          out);
    }
    for (String file : List.of("results.csv", "metrics.csv", "summary.csv")) {
      assertEquals(
          Files.readString(first.resolve(file)), Files.readString(second.resolve(file)), file);
    }
    String metrics = Files.readString(first.resolve("metrics.csv"));
    assertTrue(metrics.contains("hifi:orb-lin@chance,sarsa,0,expected_performance,"));
    assertFalse(metrics.contains("hifi:orb-lin,sarsa,0,expected_performance,"));
    for (String row : Files.readAllLines(first.resolve("results.csv")).subList(1, 13)) {
      String proportion = row.split(",")[5];
      assertTrue(proportion.isEmpty() || Double.parseDouble(proportion) <= 1, row);
    }
  }

  @Test
  void camSimsNetworkHasSameLuckAsRun() throws IOException {
    Path scenario = Cli.scenario("tutorial-camsim");
    Path network = folder.resolve("network");
    Path plain = folder.resolve("plain");
    String rule = "chance:memory=3";
    run(
        "camsim",
        "-t",
        200,
        "-o",
        folder.resolve("camsim.csv"),
        "--detection",
        "hifi:orb-power",
        "--detect",
        rule,
        "--coverage-out",
        network,
        scenario);
    run(
        "run",
        scenario,
        "--steps",
        200,
        "--policy",
        "zoom-out",
        "--detection",
        "hifi:orb-power",
        "--detect",
        rule,
        "--out",
        plain);
    assertEquals(
        Files.readString(plain.resolve("steps.csv")),
        Files.readString(network.resolve("steps.csv")));
    assertNotEquals("", Files.readString(folder.resolve("camsim.csv")));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--detect luck | unknown detection rule 'luck', expected",
        "--detect chance:alpha=1 | alpha is '1', expected a number from 1.0E-9 to 0.5",
        "--detect chance --threshold 0.4 | threshold is 0.4, expected none with --detect chance",
        "--detect chance --detection camsim-range | 'camsim-range' has no rmse",
        "--detection hifi:orb-lin@chance:x=1 | unknown option 'x=1'",
      })
  void rejectsContradictoryOptionsInOneLine(String options, String expected) {
    Object[] words = ("run " + LATTICE + " " + options).split(" ");
    Cli run = Cli.run(words);
    assertEquals(2, run.exit());
    assertTrue(run.err().startsWith("error: ") && run.err().contains(expected), run.err());
    assertEquals(1, run.err().lines().count());
  }

  private static void run(Object... words) {
    Cli run = Cli.run(words);
    assertEquals(0, run.exit(), run.err());
  }
}
