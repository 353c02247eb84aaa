package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests {@code compare --yardsticks}. */
class YardsticksTest {
  @TempDir static Path folder;
  private static Path scenario;
  private static Path byDefault;
  private static Path byBound;
  private static Cli compareByBound;

  @BeforeAll
  static void compareBothWays() {
    scenario = folder.resolve("site.xml");
    Cli.run("generate", scenario, "--lenses", "--cameras", 5, "--targets", 9, "--walls", 12);
    byDefault = folder.resolve("byDefault");
    byBound = folder.resolve("bound");
    assertEquals(0, compare(byDefault).exit());
    compareByBound = compare(byBound, "--yardsticks", "bound");
    assertEquals(0, compareByBound.exit(), compareByBound.err());
  }

  private static Cli compare(Path out, Object... options) {
    List<Object> words =
        new ArrayList<>(
            List.of(
                "compare",
                scenario,
                "--detections",
                "oodpcvs-2025:level=discern",
                "--policies",
                "independent-greedy,zoom-out",
                "--steps",
                40,
                "--repeat",
                3,
                "--latex",
                "--out",
                out));
    words.addAll(List.of(options));
    return Cli.run(words.toArray());
  }

  @Test
  void usesOptimumAndBestFixedByDefault() throws IOException {
    Path named = folder.resolve("named");
    compare(named, "--yardsticks", "optimal,best-fixed");
    for (String file : List.of("results.csv", "metrics.csv", "summary.csv", "yardsticks.csv")) {
      assertEquals(-1, Files.mismatch(byDefault.resolve(file), named.resolve(file)), file);
    }
    assertEquals(
        "optimal reached, optimal reached, optimal reached, best-fixed reached, "
            + "best-fixed reached, best-fixed reached",
        yardsticks(byDefault));
  }

  @Test
  void marksBoundAndNeverFallsBelowOptimum() throws IOException {
    assertEquals("bound at most, bound at most, bound at most", yardsticks(byBound));
    double[] optima = column(byDefault, "yardsticks.csv", "score");
    double[] bounds = column(byBound, "yardsticks.csv", "score");
    for (int seed = 0; seed < 3; seed++) {
      assertTrue(bounds[seed] >= optima[seed], bounds[seed] + " below " + optima[seed]);
      assertTrue(bounds[seed] <= 1.3 * optima[seed], bounds[seed] + " for " + optima[seed]);
    }
    assertTrue(compareByBound.out().contains("of the optimum, at least"), compareByBound.out());
    String shown = "independent-greedy reaches at least \\d+ % of what is possible";
    assertTrue(
        compareByBound.out().lines().anyMatch(line -> line.matches(".*" + shown)),
        compareByBound.out());
    assertTrue(Files.readString(byBound.resolve("summary.tex")).contains("a bound on the optimum"));
    assertTrue(Files.readString(byBound.resolve("proportion.svg")).contains("bound"));
    assertTrue(Files.readString(byBound.resolve("profile.svg")).contains("bound"));
  }

  @Test
  void yardsticksAreNotSaidToReachWhatIsPossible() {
    Cli cli =
        Cli.run(
            "compare",
            scenario,
            "--detections",
            "oodpcvs-2025",
            "--policies",
            "zoom-out,optimal",
            "--yardsticks",
            "bound",
            "--steps",
            20,
            "--repeat",
            2,
            "--out",
            folder.resolve("own"));
    assertEquals(0, cli.exit(), cli.err());
    assertTrue(cli.out().contains("zoom-out reaches at least"), cli.out());
    assertFalse(cli.out().contains("optimal reaches"), cli.out());
  }

  @Test
  void resultsWithBoundKeepRowsAndColumns() throws IOException {
    List<Map<String, String>> rows = rows(byBound, "results.csv");
    assertEquals(
        Files.readAllLines(byDefault.resolve("results.csv")).get(0),
        Files.readAllLines(byBound.resolve("results.csv")).get(0));
    assertEquals(6, rows.size());
    for (Map<String, String> row : rows) {
      assertEquals("", row.get("optimum"));
      assertEquals("", row.get("proportion_of_optimal"));
    }
    Map<String, Double> shares = metric(byBound, "proportion_of_bound");
    assertEquals(6, shares.size());
    metric(byDefault, "proportion_of_optimal")
        .forEach((run, share) -> assertTrue(run.contains("optimal") || shares.get(run) <= share));
    assertTrue(metric(byDefault, "proportion_of_bound").isEmpty());
    assertTrue(metric(byBound, "proportion_of_optimal").isEmpty());
    assertTrue(metric(byBound, "regret").isEmpty());
    assertEquals("proportion_of_bound", rows(byBound, "pairs.csv").get(0).get("metric"));
    assertEquals("proportion_of_bound", rows(byBound, "aggregate.csv").get(0).get("metric"));
  }

  @Test
  void reportsReachableAsIntervalBelowOptimum() throws IOException {
    Path reachable = folder.resolve("reachable");
    Cli compare = compare(reachable, "--yardsticks", "reachable:iterations=20");
    assertEquals(0, compare.exit(), compare.err());
    assertEquals(
        String.join(", ", Collections.nCopies(3, "reachable reached, reachable at most")),
        yardsticks(reachable));
    double[] scores = column(reachable, "yardsticks.csv", "score");
    double[] optima = column(byDefault, "yardsticks.csv", "score");
    for (int seed = 0; seed < 3; seed++) {
      assertTrue(scores[2 * seed] <= scores[2 * seed + 1]);
      assertTrue(scores[2 * seed] <= optima[seed] + 1e-9);
    }
    for (Map<String, String> row : rows(reachable, "results.csv")) {
      double share = Double.parseDouble(row.get("proportion_of_reachable"));
      assertTrue(share >= 0 && share <= 1, row.toString());
    }
    assertTrue(compare.out().contains("of what was reachable, at least"), compare.out());
  }

  @Test
  void comparesScoresWithoutYardsticks() throws IOException {
    Path none = folder.resolve("none");
    Cli compare = compare(none, "--yardsticks", "none");
    assertEquals(0, compare.exit(), compare.err());
    assertFalse(compare.out().contains("optimum"), compare.out());
    assertEquals("score", rows(none, "pairs.csv").get(0).get("metric"));
    assertTrue(rows(none, "yardsticks.csv").isEmpty());
    for (String file : List.of("aggregate.csv", "profile.csv", "proportion.svg", "profile.svg")) {
      assertFalse(Files.exists(none.resolve(file)), file);
    }
    assertTrue(Files.exists(none.resolve("report.html")));
  }

  @Test
  void acceptsBestFixedAsOnlyYardstick() throws IOException {
    Path fixed = folder.resolve("fixed");
    Cli compare = compare(fixed, "--yardsticks", "best-fixed");
    assertTrue(compare.out().contains("over best-fixed"), compare.out());
    assertEquals("value_of_learning", rows(fixed, "pairs.csv").get(0).get("metric"));
    assertEquals(metric(byDefault, "value_of_learning"), metric(fixed, "value_of_learning"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"best", "optimal,optimal", "optimal,", "none,bound", ""})
  void rejectsUnknownYardsticks(String text) {
    Cli compare = compare(folder.resolve("refused"), "--yardsticks", text);
    assertEquals(2, compare.exit());
    assertEquals(1, compare.err().lines().count(), compare.err());
    assertTrue(
        compare.err().startsWith("error: --yardsticks is '" + text + "', expected optimal"),
        compare.err());
  }

  @Test
  void rejectsMergingPartsWithOtherYardsticks() {
    Path firstPart = folder.resolve("one");
    Path secondPart = folder.resolve("two");
    compare(firstPart, "--yardsticks", "bound", "--shard", "1/2");
    compare(secondPart, "--yardsticks", "bound", "--shard", "2/2");
    Path merged = folder.resolve("merged");
    Cli withDefaults = compare(merged, "--merge", firstPart, "--merge", secondPart);
    assertEquals(2, withDefaults.exit());
    assertTrue(withDefaults.err().contains("--merge lacks 6 of 12 runs"), withDefaults.err());
    Cli withBound =
        compare(merged, "--yardsticks", "bound", "--merge", firstPart, "--merge", secondPart);
    assertEquals(0, withBound.exit(), withBound.err());
  }

  private static String yardsticks(Path out) throws IOException {
    return rows(out, "yardsticks.csv").stream()
        .map(row -> row.get("yardstick") + " " + row.get("is"))
        .collect(Collectors.joining(", "));
  }

  private static double[] column(Path out, String file, String name) throws IOException {
    return rows(out, file).stream().mapToDouble(row -> Double.parseDouble(row.get(name))).toArray();
  }

  /** Returns the values of a metric by policy and seed. */
  private static Map<String, Double> metric(Path out, String metric) throws IOException {
    Map<String, Double> values = new HashMap<>();
    for (Map<String, String> row : rows(out, "metrics.csv")) {
      if (row.get("metric").equals(metric)) {
        values.put(row.get("policy") + " " + row.get("seed"), Double.parseDouble(row.get("value")));
      }
    }
    return values;
  }

  private static List<Map<String, String>> rows(Path out, String file) throws IOException {
    List<String> lines = Files.readAllLines(out.resolve(file));
    String[] columns = lines.get(0).split(",");
    List<Map<String, String>> rows = new ArrayList<>();
    for (String line : lines.subList(1, lines.size())) {
      Map<String, String> row = new HashMap<>();
      String[] cells = line.split(",", -1);
      for (int i = 0; i < cells.length; i++) {
        row.put(columns[i], cells[i]);
      }
      rows.add(row);
    }
    return rows;
  }
}
