package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests generated scenarios with many cameras. */
class BigNetworkTest {
  private static final int STEPS = 20;
  private static final int CAMERAS = 600;
  private static final List<String> FILES =
      List.of("steps.csv", "zooms.csv", "targets.csv", "summary.json");

  @TempDir Path folder;
  private Path scenario;

  @BeforeEach
  void generate() {
    scenario = folder.resolve("big.xml");
    Cli generated = Cli.run("generate", scenario, "--cameras", CAMERAS, "--seed", 3);
    assertEquals(0, generated.exit(), generated.err());
    assertTrue(generated.out().contains("600 cameras, 360 targets"), generated.out());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "zoom-out",
        "random",
        "epsilon-greedy",
        "ucb1",
        "softmax",
        "sarsa",
        "q-learning",
        "qb-sarsa",
        "qb-sarsa:k=30,own-vote=no",
        "optimal"
      })
  void sameSeedWritesSameBytes(String policy) throws IOException {
    Path first = run(policy, "first");
    assertEquals(STEPS, Files.readAllLines(first.resolve("steps.csv")).size() - 1);
    assertEquals(CAMERAS * STEPS, Files.readAllLines(first.resolve("zooms.csv")).size() - 1);
    Path second = run(policy, "second");
    for (String file : FILES) {
      assertArrayEquals(
          Files.readAllBytes(first.resolve(file)),
          Files.readAllBytes(second.resolve(file)),
          policy + ": " + file);
    }
  }

  @Test
  void scenarioDependsOnlyOnSeed() throws IOException {
    Path again = folder.resolve("again.xml");
    Path other = folder.resolve("other.xml");
    Cli.run("generate", again, "--cameras", CAMERAS, "--seed", 3);
    Cli.run("generate", other, "--cameras", CAMERAS, "--seed", 4);
    assertEquals(-1, Files.mismatch(scenario, again));
    assertNotEquals(-1, Files.mismatch(scenario, other));
  }

  @Test
  void generatedScenarioValidatesWithoutWarnings() {
    Cli validated = Cli.run("validate", scenario);
    assertEquals(0, validated.exit(), validated.err());
    assertEquals("", validated.err());
  }

  @Test
  void rejectsArgumentsOutOfRange() {
    refused("--cameras is 0", "generate", folder.resolve("x.xml"), "--cameras", 0);
    refused("--targets is 0", "generate", folder.resolve("x.xml"), "--targets", 0);
    refused("--area is NaN", "generate", folder.resolve("x.xml"), "--area", "NaN");
    refused("is a folder", "generate", folder);
    refused("--threads is -1", "compare", scenario, "--threads", -1);
    refused("Unknown options: '--threads'", "run", scenario, "--threads", 2);
  }

  private void refused(String expected, Object... words) {
    Cli run = Cli.run(words);
    assertEquals(2, run.exit());
    assertTrue(run.err().startsWith("error: ") && run.err().contains(expected), run.err());
    assertEquals(1, run.err().lines().count(), run.err());
  }

  private Path run(String policy, String name) {
    Path out = folder.resolve(name);
    Cli run =
        Cli.run("run", scenario, "--policy", policy, "--steps", STEPS, "--record", "--out", out);
    assertEquals(0, run.exit(), run.err());
    return out;
  }
}
