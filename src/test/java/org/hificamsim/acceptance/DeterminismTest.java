package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests that the same seed gives the same bytes in every file except the manifest. */
class DeterminismTest {
  private static final int STEPS = 400;
  private static final int REPEATS = 3;
  private static final List<String> FILES =
      List.of("steps.csv", "zooms.csv", "targets.csv", "summary.json", "replay.json");

  @TempDir Path folder;

  static List<String> scenarios() {
    return Cli.SIX;
  }

  @ParameterizedTest
  @MethodSource("scenarios")
  void sameCommandWritesSameBytes(String scenario) throws IOException {
    Path first = record(scenario, "first", 7, "epsilon-greedy");
    Path second = record(scenario, "second", 7, "epsilon-greedy");
    for (String file : FILES) {
      assertArrayEquals(
          Files.readAllBytes(first.resolve(file)), Files.readAllBytes(second.resolve(file)), file);
    }
    assertEquals(STEPS * REPEATS, Files.readAllLines(first.resolve("steps.csv")).size() - 1);
  }

  @Test
  void otherSeedGivesOtherRun() throws IOException {
    Path first = record("lattice-random", "first", 7, "epsilon-greedy");
    Path second = record("lattice-random", "second", 8, "epsilon-greedy");
    for (String file : FILES) {
      assertFalse(
          Arrays.equals(
              Files.readAllBytes(first.resolve(file)), Files.readAllBytes(second.resolve(file))),
          file);
    }
  }

  @Test
  void repeatIUsesSeedPlusI() throws IOException {
    Path all = record("ring-random", "all", 20, "random");
    Path second = folder.resolve("second");
    Cli.run(
        "run",
        Cli.scenario("ring-random"),
        "--policy",
        "random",
        "--steps",
        STEPS,
        "--seed",
        21,
        "--out",
        second,
        "--record");
    for (String file : List.of("steps.csv", "zooms.csv", "targets.csv")) {
      assertEquals(rows(second.resolve(file), "0,"), rows(all.resolve(file), "1,"), file);
    }
  }

  @Test
  void targetsMoveEquallyUnderEveryPolicy() throws IOException {
    Path calm = record("cluster-random", "calm", 3, "zoom-out");
    Path wild = record("cluster-random", "wild", 3, "random");
    assertArrayEquals(
        Files.readAllBytes(calm.resolve("targets.csv")),
        Files.readAllBytes(wild.resolve("targets.csv")));
  }

  private Path record(String scenario, String name, int seed, String policy) {
    Path out = folder.resolve(name);
    Cli run =
        Cli.run(
            "run",
            Cli.scenario(scenario),
            "--policy",
            policy,
            "--steps",
            STEPS,
            "--seed",
            seed,
            "--repeat",
            REPEATS,
            "--record",
            "--out",
            out);
    assertEquals(0, run.exit(), run.err());
    return out;
  }

  /** The rows of one run, without its number. */
  private static List<String> rows(Path csv, String run) throws IOException {
    try (Stream<String> lines = Files.lines(csv)) {
      return lines
          .filter(line -> line.startsWith(run))
          .map(line -> line.substring(run.length()))
          .toList();
    }
  }
}
