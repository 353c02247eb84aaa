package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests what runs and comparisons report if the exact optimum runs out of search nodes. */
class ProofTest {
  @TempDir Path folder;

  @Test
  void runReportsUnprovenStepsWithTheirBound() throws IOException {
    Path scenario = denseScenario();
    Cli limited = run(scenario, "one-hop:nodes=0");
    JsonNode unproven = summary();
    assertTrue(limited.out().contains("not proven"), limited.out());
    assertTrue(unproven.get("unproven_steps").asInt() > 0);
    assertTrue(unproven.get("performance_bound").asLong() > unproven.get("performance").asLong());
    Cli exact = run(scenario, "optimal");
    JsonNode proven = summary();
    assertFalse(exact.out().contains("not proven"), exact.out());
    assertEquals(0, proven.get("unproven_steps").asInt());
    assertEquals(proven.get("performance"), proven.get("performance_bound"));
  }

  @Test
  void otherPoliciesReportNoProof() throws IOException {
    run(Cli.scenario("cluster-random"), "sarsa");
    assertFalse(summary().has("unproven_steps"));
  }

  @Test
  void comparisonReportsUnprovenSteps() throws IOException {
    Cli compared = compare(denseScenario());
    assertTrue(
        compared.err().contains("'one-hop:nodes=0' is not proven to be the best in "),
        compared.err());
    assertFalse(compared.err().contains("'optimal' is not proven"), compared.err());
    assertTrue(figure("one-hop:nodes=0", "unproven_steps") > 0);
    assertTrue(
        figure("one-hop:nodes=0", "performance_bound") > figure("one-hop:nodes=0", "performance"));
    assertEquals(0, figure("optimal", "unproven_steps"));
    assertEquals(figure("optimal", "performance"), figure("optimal", "performance_bound"));
    assertFalse(metrics().anyMatch(row -> row.contains(",zoom-out,") && row.contains("_bound,")));
  }

  /**
   * Writes a scenario of many close cameras with lenses, where no view sees all that another sees.
   */
  private Path denseScenario() throws IOException {
    Path scenario = folder.resolve("dense.xml");
    Cli.run("generate", scenario, "--cameras", 24, "--targets", 30, "--area", 1);
    String lens =
        "<optics name='lens' law='constant-area' reach='4' hfov='160 80 40' pan='-90 0 90'/>";
    String withoutLenses = Files.readString(scenario);
    return Files.writeString(
        scenario,
        withoutLenses
            .replaceFirst("<zoom>.*</zoom>", lens)
            .replace("viewing_angle=\"360.0\"", "optics=\"lens\""));
  }

  private Cli run(Path scenario, String policy) {
    Cli run =
        Cli.run("run", scenario, "--policy", policy, "--steps", 30, "--out", folder.resolve("out"));
    assertEquals(0, run.exit(), run.err());
    return run;
  }

  private Cli compare(Path scenario) {
    Cli run =
        Cli.run(
            "compare",
            scenario,
            "--detections",
            "hifi:orb-lin",
            "--policies",
            "zoom-out,one-hop:nodes=0",
            "--steps",
            30,
            "--repeat",
            1,
            "--out",
            folder.resolve("out"));
    assertEquals(0, run.exit(), run.err());
    return run;
  }

  private double figure(String policy, String metric) throws IOException {
    String row =
        metrics()
            .filter(line -> line.contains("," + policy + ",0," + metric + ","))
            .findAny()
            .get();
    return Double.parseDouble(row.substring(row.lastIndexOf(',') + 1));
  }

  private Stream<String> metrics() throws IOException {
    return Files.readAllLines(folder.resolve("out/metrics.csv")).stream();
  }

  private JsonNode summary() throws IOException {
    return new ObjectMapper()
        .readTree(folder.resolve("out/summary.json").toFile())
        .get("runs")
        .get(0);
  }
}
