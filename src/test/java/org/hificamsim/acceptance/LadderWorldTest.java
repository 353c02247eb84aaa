package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests {@code ladder --of world} by computing its results again from the runs that it wrote. */
class LadderWorldTest {
  private static final List<String> RUNGS =
      List.of("round", "optics", "pan", "time", "walls", "occlusion");
  private static final List<String> POLICIES = List.of("zoom-out", "zoom-in", "greedy");
  private static final int STEPS = 30;

  @TempDir static Path folder;
  private static Path out;
  private static Cli ladder;

  @BeforeAll
  static void climb() {
    out = folder.resolve("ladder");
    ladder = run(out);
    assertEquals(0, ladder.exit(), ladder.err());
  }

  private static Cli run(Path there, Object... more) {
    return Cli.run(
        Stream.concat(
                Stream.of(
                    "ladder",
                    "--of",
                    "world",
                    Cli.scenario("hall"),
                    "--policies",
                    String.join(",", POLICIES),
                    "--steps",
                    STEPS,
                    "--repeat",
                    2,
                    "--out",
                    there),
                Arrays.stream(more))
            .toArray());
  }

  @Test
  void rungsRiseFromRoundViewsToWholeScenario() {
    assertEquals(RUNGS, rows("rungs.csv").stream().map(row -> row[1]).limit(RUNGS.size()).toList());
    assertEquals("1.0", row("occlusion")[3]);
    assertEquals("0.0", row("occlusion")[7]);
  }

  @Test
  void judgesPoliciesByObjectiveOfScenario() {
    for (String[] row : rows("ladder.csv")) {
      assertEquals(mean(row[1], row[2]), Double.parseDouble(row[3]), 1e-9, row[1] + row[2]);
    }
    assertTrue(ladder.out().contains("score lost, %"), ladder.out());
    assertFalse(ladder.out().contains("k_min lost"), ladder.out());
  }

  @Test
  void optimumIsOfSameObjective() {
    for (String rung : RUNGS) {
      assertEquals(mean(rung, "optimal"), Double.parseDouble(row(rung)[2]), 1e-9, rung);
    }
  }

  @Test
  void regretIsLossInWholeScenario() {
    double[] top = means("occlusion");
    double best = Arrays.stream(top).max().orElseThrow();
    for (String rung : RUNGS) {
      double[] own = means(rung);
      double most = Arrays.stream(own).max().orElseThrow();
      double kept = 0;
      int chosen = 0;
      for (int i = 0; i < own.length; i++) {
        if (own[i] > most - 1e-12) {
          kept += top[i];
          chosen++;
        }
      }
      assertEquals(best - kept / chosen, Double.parseDouble(row(rung)[7]), 1e-9, rung);
    }
  }

  @Test
  void everyRungChangesResults() {
    assertEquals(
        RUNGS.size(), RUNGS.stream().map(rung -> Arrays.toString(means(rung))).distinct().count());
  }

  @Test
  void writesScenarioOfEachRung() throws IOException {
    String round = Files.readString(out.resolve("scenario-hall-round.xml"));
    assertTrue(round.contains("<zoom>") && !round.contains("hfov"), round);
    Path there = folder.resolve("round");
    Cli run =
        Cli.run(
            "compare",
            out.resolve("scenario-hall-round.xml"),
            "--detections",
            "dori-2014:level=recognise",
            "--policies",
            "zoom-out",
            "--steps",
            STEPS,
            "--repeat",
            2,
            "--out",
            there);
    assertEquals(0, run.exit(), run.err());
    assertEquals(
        mean("round", "zoom-out"), mean(rows(there.resolve("metrics.csv")), "zoom-out"), 1e-9);
  }

  @Test
  void acceptsSelectedRungsAndAnotherDetection() {
    Path there = folder.resolve("some");
    Cli some = run(there, "--rungs", "optics, occlusion", "--detection", "ttpf:task=identify");
    assertEquals(0, some.exit(), some.err());
    List<String[]> found = rows(there.resolve("rungs.csv"));
    assertEquals(List.of("optics", "occlusion"), List.of(found.get(0)[1], found.get(1)[1]));
    assertEquals("ttpf:task=identify", rows(there.resolve("metrics.csv")).get(0)[1]);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--of world --rungs round,nix | unknown rung 'nix', expected one of round, optics",
        "--of world --rungs round,round | rungs 'round' and 'round' are both detection",
        "--of world --detection nix | unknown detection 'nix'",
        "--of worlds | --of is 'worlds', expected one of detection, world",
        "--of world --detect chance | --detect is 'chance', expected none",
        "--detection geometric | --detection is 'geometric', expected none without --of world",
      })
  void rejectsWrongUsageInOneLine(String options, String expected) {
    Path nowhere = folder.resolve("nowhere");
    Cli.assertRejects(options, expected, nowhere, "ladder", Cli.scenario("hall"));
  }

  private static double[] means(String rung) {
    return POLICIES.stream().mapToDouble(policy -> mean(rung, policy)).toArray();
  }

  /** Returns the mean score of a step. */
  private static double mean(String rung, String policy) {
    String scenario = rung.equals("occlusion") ? "hall" : "hall-" + rung;
    return mean(
        rows("metrics.csv").stream().filter(row -> row[0].equals(scenario)).toList(), policy);
  }

  private static double mean(List<String[]> metrics, String policy) {
    double[] values =
        metrics.stream()
            .filter(row -> row[2].equals(policy) && row[4].equals("score"))
            .mapToDouble(row -> Double.parseDouble(row[5]))
            .toArray();
    assertEquals(2, values.length, policy);
    return DoubleStream.of(values).average().orElseThrow() / STEPS;
  }

  private static String[] row(String rung) {
    return rows("rungs.csv").stream()
        .filter(row -> row[0].equals("hall") && row[1].equals(rung))
        .findFirst()
        .orElseThrow();
  }

  private static List<String[]> rows(String file) {
    return rows(out.resolve(file));
  }

  private static List<String[]> rows(Path file) {
    try {
      return Files.readAllLines(file).stream()
          .skip(1)
          .map(line -> line.replace("\"", "").split(",", -1))
          .toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
