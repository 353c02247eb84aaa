package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a run says where the exact optimum ran out of search nodes. */
class ProofTest {
  @TempDir Path folder;

  @Test
  void stepsWithoutAProofAreToldWithTheirBound() throws IOException {
    Path scenario = folder.resolve("dense.xml");
    Cli.run("generate", scenario, "--cameras", 60, "--targets", 30, "--area", 3);
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
  void policiesThatProveNothingSayNothing() throws IOException {
    run(Cli.scenario("cluster-random"), "sarsa");
    assertFalse(summary().has("unproven_steps"));
  }

  private Cli run(Path scenario, String policy) {
    Cli run =
        Cli.run("run", scenario, "--policy", policy, "--steps", 30, "--out", folder.resolve("out"));
    assertEquals(0, run.exit(), run.err());
    return run;
  }

  private JsonNode summary() throws IOException {
    return new ObjectMapper()
        .readTree(folder.resolve("out/summary.json").toFile())
        .get("runs")
        .get(0);
  }
}
