package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests {@code ladder} by computing its results again from the runs that it wrote. */
class LadderCommandTest {
  private static final List<String> SCENARIOS = List.of("ring-random", "cluster-scripted");
  private static final String TOP = "hifi:orb-lin@chance";
  private static final List<String> RUNGS =
      List.of("geometric", "camsim-range", "hifi:orb-lin", TOP);
  private static final List<String> POLICIES =
      List.of("zoom-out", "epsilon-greedy", "sarsa", "best-fixed");
  private static final int STEPS = 60;
  private static final Set<String> NOT_REPRODUCIBLE =
      Set.of(
          "manifest.json",
          "ro-crate-metadata.json",
          "report.html",
          "cost.json",
          "cost.png",
          "cost.svg",
          "cost.pdf");

  @TempDir static Path folder;
  private static Path out;
  private static Cli ladder;

  @BeforeAll
  static void climb() {
    out = folder.resolve("ladder");
    ladder = Cli.run(words(out, 1));
    assertEquals(0, ladder.exit(), ladder.err());
  }

  @Test
  void predictsMeanKMinAndRanks() throws IOException {
    List<String[]> rows = rows("ladder.csv");
    assertEquals(SCENARIOS.size() * RUNGS.size() * POLICIES.size(), rows.size());
    for (String[] row : rows) {
      double[] means = means(row[0], row[1]);
      double own = means[POLICIES.indexOf(row[2])];
      assertEquals(own, Double.parseDouble(row[3]), 1e-9, row[0] + row[1] + row[2]);
      long better = Arrays.stream(means).filter(other -> other > own + 1e-12).count();
      assertEquals(1 + better, Long.parseLong(row[6]), row[0] + row[1] + row[2]);
    }
  }

  @Test
  void tauComparesOrderWithTopRung() throws IOException {
    for (String scenario : SCENARIOS) {
      for (String rung : RUNGS) {
        double expected = tau(means(scenario, rung), means(scenario, TOP));
        String tau = row(scenario, rung)[3];
        assertEquals(Double.isNaN(expected), tau.isEmpty(), tau);
        if (!tau.isEmpty()) {
          assertEquals(expected, Double.parseDouble(tau), 1e-9, scenario + rung);
        }
      }
      assertEquals("1.0", row(scenario, TOP)[3]);
    }
  }

  @Test
  void regretIsLossUnderTopRung() throws IOException {
    for (String scenario : SCENARIOS) {
      double[] top = means(scenario, TOP);
      double best = Arrays.stream(top).max().orElseThrow();
      for (String rung : RUNGS) {
        String[] row = row(scenario, rung);
        double[] own = means(scenario, rung);
        double most = Arrays.stream(own).max().orElseThrow();
        List<String> chosen = new ArrayList<>();
        double sum = 0;
        for (int i = 0; i < own.length; i++) {
          if (own[i] > most - 1e-12) {
            chosen.add(POLICIES.get(i));
            sum += top[i];
          }
        }
        assertEquals(String.join(" | ", chosen), row[6]);
        double regret = best - sum / chosen.size();
        assertEquals(regret, Double.parseDouble(row[7]), 1e-9, scenario + rung);
        assertTrue(Double.parseDouble(row[8]) >= 0, row[8]);
        assertTrue(Double.parseDouble(row[9]) >= Double.parseDouble(row[8]), row[9]);
        assertEquals(regret / best, Double.parseDouble(row[10]), 1e-9);
      }
      assertEquals(0, Double.parseDouble(row(scenario, TOP)[7]));
    }
  }

  @Test
  void optimumIsOfSameRung() throws IOException {
    for (String scenario : SCENARIOS) {
      for (String rung : RUNGS) {
        double expected = mean(scenario, rung, "optimal", "performance") / STEPS;
        assertEquals(expected, Double.parseDouble(row(scenario, rung)[2]), 1e-9);
      }
    }
  }

  @Test
  void lastRowsAreMeansOverScenarios() throws IOException {
    for (String rung : RUNGS) {
      for (int column : new int[] {2, 3, 7, 10}) {
        double expected =
            SCENARIOS.stream()
                .map(scenario -> row(scenario, rung)[column])
                .filter(text -> !text.isEmpty())
                .mapToDouble(Double::parseDouble)
                .average()
                .orElse(Double.NaN);
        String text = row("all", rung)[column];
        assertEquals(expected, text.isEmpty() ? Double.NaN : Double.parseDouble(text), 1e-9, rung);
      }
    }
  }

  @Test
  void someRungsDisagreeWithTopRung() throws IOException {
    Set<String> predictions = new TreeSet<>();
    for (String[] row : rows("ladder.csv")) {
      predictions.add(row[3]);
    }
    assertTrue(predictions.size() > RUNGS.size() * SCENARIOS.size(), predictions.toString());
    assertTrue(
        rows("rungs.csv").stream().anyMatch(row -> !row[3].isEmpty() && !row[3].equals("1.0")));
  }

  @Test
  void printsAndWritesCostOfAStep() throws IOException {
    JsonNode cost = new ObjectMapper().readTree(out.resolve("cost.json").toFile());
    assertEquals("zoom-out", cost.get("policy").asText());
    List<String> found = new ArrayList<>();
    for (JsonNode step : cost.get("steps")) {
      assertTrue(step.get("nanoseconds").asDouble() > 0, step.toString());
      found.add(step.get("scenario").asText() + " " + step.get("rung").asText());
    }
    assertEquals(
        SCENARIOS.stream().flatMap(s -> RUNGS.stream().map(rung -> s + " " + rung)).toList(),
        found);
    List<String> lines = ladder.out().lines().filter(line -> line.startsWith("all")).toList();
    assertEquals(RUNGS.size(), lines.size(), ladder.out());
  }

  @Test
  void writesPictureAndPage() throws IOException {
    for (String name : List.of("ladder.svg", "ladder.pdf", "cost.pdf", "cost.png")) {
      assertTrue(Files.size(out.resolve(name)) > 3000, name);
    }
    String page = Files.readString(out.resolve("report.html"));
    assertTrue(page.contains("rungs.csv") && page.contains("ladder.svg"));
  }

  @Test
  void writesSameBytesOnTwoThreads() throws IOException {
    Path again = folder.resolve("again");
    assertEquals(0, Cli.run(words(again, 2)).exit());
    assertEquals(Cli.names(out), Cli.names(again));
    for (String name : Cli.names(out)) {
      if (!NOT_REPRODUCIBLE.contains(name)) {
        assertArrayEquals(
            Files.readAllBytes(out.resolve(name)), Files.readAllBytes(again.resolve(name)), name);
      }
    }
  }

  @Test
  void mergedShardsGiveSameTables() throws IOException {
    Path[] parts = {folder.resolve("part-1"), folder.resolve("part-2")};
    for (int i = 0; i < parts.length; i++) {
      assertEquals(0, Cli.run(words(parts[i], 1, "--shard", (i + 1) + "/2")).exit());
    }
    Path merged = folder.resolve("merged");
    Cli merge = Cli.run(words(merged, 1, "--merge", parts[0], parts[1]));
    assertEquals(0, merge.exit(), merge.err());
    for (String name : List.of("rungs.csv", "ladder.csv", "ladder.svg", "ladder.pdf")) {
      assertArrayEquals(
          Files.readAllBytes(out.resolve(name)), Files.readAllBytes(merged.resolve(name)), name);
    }
  }

  @Test
  void rungWithoutRuleIgnoresRuleOfScenario() throws IOException {
    Path chance = folder.resolve("chance.xml");
    String text = Files.readString(Cli.scenario("ring-random"));
    Files.writeString(chance, text.replaceFirst("<simulation ", "<simulation detect=\"chance\" "));
    assertTrue(Files.readString(chance).contains("detect=\"chance\""));
    Path there = folder.resolve("chance");
    Cli cli =
        Cli.run(
            "ladder",
            chance,
            "--rungs",
            "geometric,hifi:orb-lin,hifi:orb-lin@chance",
            "--policies",
            "zoom-out,zoom-in",
            "--steps",
            10,
            "--repeat",
            2,
            "--quiet",
            "--out",
            there);
    assertEquals(new Cli(0, "", ""), cli);
    String results = Files.readString(there.resolve("results.csv"));
    assertTrue(results.contains("\nchance,hifi:orb-lin,zoom-out,"), results);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--rungs geometric,nix | unknown detection 'nix'",
        "--rungs geometric@chance | detection 'geometric' has no rmse",
        "--rungs geometric,geometric | rungs 'geometric' and 'geometric' are both detection",
        "--rungs geometric,geometric@threshold | 'geometric@threshold' are both detection",
        "--policies sarsa | the policies are 'sarsa' alone, expected two or more",
        "--policies sarsa,sarsa | 'sarsa' twice",
        "--policies sarsa,nix | unknown policy 'nix'",
        "--detect chance | --detect is 'chance', expected none",
      })
  void rejectsWrongUsageInOneLine(String options, String expected) {
    Path nowhere = folder.resolve("nowhere");
    Cli.assertRejects(options, expected, nowhere, "ladder", Cli.scenario("ring-random"));
  }

  /** Returns Kendall's tau-b, by its definition over all pairs. */
  private static double tau(double[] a, double[] b) {
    int balance = 0;
    int pairsOfA = 0;
    int pairsOfB = 0;
    for (int i = 0; i < a.length; i++) {
      for (int j = i + 1; j < a.length; j++) {
        double signOfA = Math.abs(a[i] - a[j]) < 1e-12 ? 0 : Math.signum(a[i] - a[j]);
        double signOfB = Math.abs(b[i] - b[j]) < 1e-12 ? 0 : Math.signum(b[i] - b[j]);
        balance += (int) (signOfA * signOfB);
        pairsOfA += signOfA == 0 ? 0 : 1;
        pairsOfB += signOfB == 0 ? 0 : 1;
      }
    }
    return balance / Math.sqrt((double) pairsOfA * pairsOfB);
  }

  /**
   * Returns the mean k_min of each policy in the runs; if detection is by chance, the expected one.
   */
  private static double[] means(String scenario, String rung) {
    String metric = rung.contains("@chance") ? "expected_performance" : "performance";
    return POLICIES.stream()
        .mapToDouble(policy -> mean(scenario, rung, policy, metric) / STEPS)
        .toArray();
  }

  private static double mean(String scenario, String rung, String policy, String metric) {
    double[] values =
        rows("metrics.csv").stream()
            .filter(
                row ->
                    row[0].equals(scenario)
                        && row[1].equals(rung)
                        && row[2].equals(policy)
                        && row[4].equals(metric))
            .mapToDouble(row -> Double.parseDouble(row[5]))
            .toArray();
    assertEquals(3, values.length, scenario + rung + policy + metric);
    return DoubleStream.of(values).average().orElseThrow();
  }

  private static String[] row(String scenario, String rung) {
    List<String[]> found =
        rows("rungs.csv").stream()
            .filter(row -> row[0].equals(scenario) && row[1].equals(rung))
            .toList();
    assertEquals(1, found.size(), scenario + rung);
    return found.get(0);
  }

  private static List<String[]> rows(String file) {
    try {
      return Files.readAllLines(out.resolve(file)).stream()
          .skip(1)
          .map(line -> line.replace("\"", "").split(",", -1))
          .toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static Object[] words(Path path, int threads, Object... more) {
    return Stream.concat(
            Stream.of(
                "ladder",
                Cli.scenario(SCENARIOS.get(0)),
                Cli.scenario(SCENARIOS.get(1)),
                "--rungs",
                String.join(",", RUNGS),
                "--policies",
                String.join(",", POLICIES),
                "--steps",
                STEPS,
                "--repeat",
                3,
                "--threads",
                threads,
                "--out",
                path),
            Arrays.stream(more))
        .toArray();
  }
}
