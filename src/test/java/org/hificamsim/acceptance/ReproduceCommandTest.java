package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests {@code reproduce}. */
class ReproduceCommandTest {
  private static final List<String> FIGURES =
      Stream.of("7.3", "7.4", "7.6", "7.7", "7.8", "7.9", "8.1").map("figure-"::concat).toList();

  /** The statements that {@code reproduction.md} confirms under every reading of the thesis. */
  private static final List<String> ROBUST =
      List.of(
          "baselines-below-greedy",
          "order-of-policies",
          "epsilon-greedy-above-zoom-out",
          "zoom-out-not-optimal",
          "camsim-underestimates");

  @TempDir Path folder;

  @Test
  void writesSameFilesOnAnyNumberOfThreads() throws IOException {
    Path onOneThread = reproduced(1).folder();
    Path many = reproduced(3).folder();
    for (String file : files()) {
      assertArrayEquals(
          Files.readAllBytes(onOneThread.resolve(file)),
          Files.readAllBytes(many.resolve(file)),
          file);
    }
    assertEquals(19, Files.readAllLines(onOneThread.resolve("table-8.1.csv")).size());
  }

  @Test
  void robustStatementsHoldAtModerateSize() throws IOException {
    List<String> verdicts = Files.readAllLines(reproduced(1).folder().resolve("verdicts.csv"));
    for (String id : ROBUST) {
      String row =
          verdicts.stream().filter(line -> line.contains("," + id + ",")).findFirst().get();
      assertFalse(
          row.contains(",not reproduced,"),
          row); // but it may be within the interval, which is wide with four seeds
      Matcher held = Pattern.compile("(\\d+) of (\\d+) checks hold").matcher(row);
      assertTrue(held.find() && held.group(1).equals(held.group(2)), row);
    }
  }

  @Test
  void zoomOnlyFormulaGivesZeroForZoomOut() throws IOException {
    Path out = reproduced(1).folder();
    List<String> header = List.of(line(out, "table-8.1.csv", "layout,").split(",", -1));
    for (String layout : List.of("lattice", "ring", "cluster")) {
      String[] cells = line(out, "table-8.1.csv", layout + ",zoom-out,camsim-range").split(",", -1);
      assertEquals(0, Double.parseDouble(cells[header.indexOf("eq_6.2")]), layout);
    }
    assertTrue(Files.readString(out.resolve("verdicts.csv")).contains("depends on the zoom alone"));
  }

  @Test
  void saysFirstThatOptimumIsStatic() throws IOException {
    Path out = reproduced(1).folder();
    Cli run = reproduced(1).cli();
    assertTrue(run.out().startsWith("The optimum is static: fixed:2 has the k_min"), run.out());
    assertTrue(run.out().contains("in 12 of 12 cases"), run.out());
    assertTrue(run.out().contains("fitted "), run.out());
    List<String> verdicts = Files.readAllLines(out.resolve("verdicts.csv"));
    assertEquals(
        9,
        verdicts.stream()
            .filter(row -> row.startsWith("cell,") && row.endsWith(",fitted"))
            .count());
    assertEquals(
        9,
        verdicts.stream()
            .filter(row -> row.startsWith("cell,") && row.endsWith(",held out"))
            .count());
  }

  @Test
  void optimumEqualsFixedZoomInAllScenarios() throws IOException {
    for (String detection : List.of("hifi:orb-lin", "camsim-range")) {
      for (String scenario : Cli.SIX) {
        assertArrayEquals(
            steps(scenario, detection, "optimal"),
            steps(scenario, detection, "fixed:2"),
            scenario + " under " + detection);
      }
    }
  }

  private byte[] steps(String scenario, String detection, String policy) throws IOException {
    Path out = folder.resolve(String.join("-", scenario, detection, policy).replace(':', '-'));
    Cli run =
        Cli.run(
            "run",
            Cli.scenario(scenario),
            "--detection",
            detection,
            "--policy",
            policy,
            "--steps",
            1000,
            "--repeat",
            2,
            "--out",
            out);
    assertEquals(0, run.exit(), run.err());
    byte[] steps = Files.readAllBytes(out.resolve("steps.csv"));
    assertTrue(steps.length > 20_000, scenario);
    return steps;
  }

  private static String line(Path folder, String file, String start) throws IOException {
    return Files.readAllLines(folder.resolve(file)).stream()
        .filter(row -> row.startsWith(start))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void rejectsInvalidNumbersInOneLine() {
    Cli run = Cli.run("reproduce", "--steps", 0, "--out", folder.resolve("none"));
    assertEquals(2, run.exit());
    assertTrue(run.err().contains("--steps is 0"), run.err());
    assertTrue(Files.notExists(folder.resolve("none")));
  }

  private static List<String> files() {
    return Stream.concat(
            Stream.of("adapting.csv", "table-8.1.csv", "verdicts.csv"),
            Stream.concat(FIGURES.stream(), Stream.of("table-8.1"))
                .flatMap(name -> Stream.of(name + ".png", name + ".svg", name + ".pdf")))
        .toList();
  }

  /** Returns the results of a reproduction of moderate size. */
  static Results reproduced(int threads) {
    return Results.of("reproduce", "--steps", 1500, "--repeat", 4, "--threads", threads);
  }
}
