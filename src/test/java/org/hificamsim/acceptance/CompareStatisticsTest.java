package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the statistics that {@code compare} computes over many runs. */
class CompareStatisticsTest {
  private static final int SEEDS = 6;
  private static final double ROUNDING = 1e-9;

  @TempDir static Path folder;
  private static Path out;
  private static Cli compare;

  @BeforeAll
  static void compare() {
    out = folder.resolve("compared");
    compare = run(out, SEEDS, "zoom-out,epsilon-greedy,sarsa", "--details", "--steps", 60);
    assertEquals(0, compare.exit(), compare.err());
  }

  @Test
  void printsShareOfLeadingYardstickUnlessAskedForDetails() {
    Cli plain = run(folder.resolve("plain"), 2, "zoom-out,sarsa", "--steps", 20);
    assertTrue(plain.out().contains("of the optimum [95%]"), plain.out());
    assertFalse(plain.out().contains("over best-fixed"), plain.out());
    assertFalse(plain.out().contains("interquartile mean"), plain.out());
  }

  @Test
  void warnsOfFewSeeds() {
    String warning = "warning: --repeat " + SEEDS + ": with fewer than 10 seeds";
    assertTrue(compare.err().contains(warning), compare.err());
    assertFalse(run(folder.resolve("ten"), 10, "zoom-out", "--steps", 5).err().contains(warning));
  }

  @Test
  void resultsHaveOptimumOfEachProportion() throws IOException {
    boolean zero = false;
    for (Map<String, String> row : rows(out, "results.csv", row -> true)) {
      double optimum = number(row, "optimum");
      zero |= optimum == 0;
      assertEquals(
          optimum == 0 ? Double.NaN : number(row, "performance") / optimum,
          number(row, "proportion_of_optimal"),
          ROUNDING);
    }
    assertTrue(zero, "no optimum of 0 among the runs");
  }

  @Test
  void comparesAdaptingAndLearningWithBestFixed() throws IOException {
    Path asked = folder.resolve("asked");
    run(asked, SEEDS, "zoom-out,epsilon-greedy,sarsa,best-fixed", "--steps", 60);
    Map<String, Double> fixed = metric(asked, "performance", "best-fixed");
    assertEquals(fixed, metric(out, "best_fixed", "optimal"));
    assertEquals(4 * SEEDS, fixed.size());
    assertRatio("value_of_adapting", "optimal", fixed);
    assertRatio("value_of_learning", "sarsa", fixed);
    assertTrue(compare.out().contains("over best-fixed [95%]"), compare.out());
  }

  private static void assertRatio(String value, String policy, Map<String, Double> fixed)
      throws IOException {
    Map<String, Double> performance = metric(out, "performance", policy);
    metric(out, value, policy)
        .forEach(
            (run, ratio) -> {
              double divisor = fixed.get(run);
              double expected = divisor == 0 ? Double.NaN : performance.get(run) / divisor;
              assertEquals(expected, ratio, ROUNDING, run);
            });
  }

  @Test
  void bestFixedIsCaseOnlyIfAskedFor() throws IOException {
    for (String file : List.of("results.csv", "summary.csv", "metrics.csv", "settings.json")) {
      assertFalse(Files.readString(out.resolve(file)).contains("best-fixed"), file);
    }
    assertFalse(compare.out().replace("over best-fixed", "").contains("best-fixed"), compare.out());
  }

  @Test
  void oneSeedHasNoInterval() throws IOException {
    Path single = folder.resolve("single");
    Cli cli = run(single, 1, "zoom-out,sarsa", "--steps", 300);
    assertFalse(cli.out().replace("[95%]", "").contains("["), cli.out());
    for (String file : List.of("summary.csv", "aggregate.csv", "profile.csv", "improvement.csv")) {
      for (Map<String, String> row : rows(single, file, row -> true)) {
        assertEquals("", row.get("low") + row.get("high"), file);
      }
    }
    assertEquals("", rows(single, "pairs.csv", row -> true).get(0).get("p_holm"));
    assertEquals(0, Cli.run("report", single).exit());
  }

  @Test
  void countsRunsWithAValue() throws IOException {
    int partly = 0;
    for (Map<String, String> row :
        rows(out, "summary.csv", row -> row.get("metric").equals("proportion_of_optimal"))) {
      long known =
          rows(out, "metrics.csv", run -> sameCase(run, row)).stream()
              .filter(run -> run.get("metric").equals("proportion_of_optimal"))
              .filter(run -> !run.get("value").isEmpty())
              .count();
      assertEquals(known, Long.parseLong(row.get("runs")));
      partly += known > 0 && known < SEEDS ? 1 : 0;
      assertEquals(known < 2, row.get("low").isEmpty());
    }
    assertTrue(partly > 0, "no case with values for some seeds alone");
    assertTrue(compare.out().contains("/" + SEEDS + ": "), compare.out());
  }

  @Test
  void interquartileMeanIsOverAllScenarios() throws IOException {
    List<Double> scores = new ArrayList<>();
    for (Map<String, String> row : rows(out, "results.csv", CompareStatisticsTest::sarsaHifi)) {
      if (!row.get("proportion_of_optimal").isEmpty()) {
        scores.add(number(row, "proportion_of_optimal"));
      }
    }
    Collections.sort(scores);
    int cut = scores.size() / 4;
    double expected =
        scores.subList(cut, scores.size() - cut).stream().mapToDouble(d -> d).average().orElse(-1);
    List<Map<String, String>> rows = rows(out, "aggregate.csv", CompareStatisticsTest::sarsaHifi);
    assertEquals(
        List.of("iqm", "optimality_gap", "mean", "median"),
        rows.stream().map(row -> row.get("statistic")).toList());
    assertEquals(expected, number(rows.get(0), "value"), ROUNDING);
    assertEquals(scores.size(), number(rows.get(0), "runs"));
    assertTrue(compare.out().contains("interquartile mean [95%]"), compare.out());
  }

  @Test
  void comparesEveryPairOfPoliciesIfAskedTo() throws IOException {
    Path out = folder.resolve("all");
    Cli cli = run(out, SEEDS, "zoom-out,epsilon-greedy,sarsa", "--steps", 60, "--reference", "all");
    assertTrue(cli.out().contains("6 seeds cannot show any of 12 differences"), cli.out());
    assertTrue(cli.out().contains("take 9 seeds, or compare with one policy"), cli.out());
    List<Map<String, String>> pairs = rows(out, "pairs.csv", row -> true);
    assertEquals(2 * 2 * 3, pairs.size());
    assertEquals(2 * 3, rows(out, "improvement.csv", row -> true).size());
    for (Map<String, String> row : pairs) {
      if (!row.get("p_value").isEmpty()) {
        assertTrue(number(row, "p_holm") >= number(row, "p_value"), row.toString());
      }
    }
    long tests = pairs.stream().filter(row -> !row.get("p_value").isEmpty()).count();
    assertEquals(12, tests, "the number that the terminal names");
    Map<String, String> first = pairs.get(0);
    Map<String, Double> values = metric(out, "proportion_of_optimal", first.get("policy"));
    Map<String, Double> otherValues = metric(out, "proportion_of_optimal", first.get("other"));
    double mean =
        values.entrySet().stream()
            .filter(run -> run.getKey().startsWith("lattice-random,camsim-range,"))
            .mapToDouble(run -> run.getValue() - otherValues.get(run.getKey()))
            .average()
            .orElseThrow();
    assertEquals("lattice-random", first.get("scenario"));
    assertEquals(mean, number(first, "difference"), ROUNDING);
  }

  @Test
  void comparesPoliciesWithFirstOrReference() throws IOException {
    List<Map<String, String>> pairs = rows(out, "pairs.csv", row -> true);
    assertEquals(2 * 2 * 2, pairs.size());
    assertTrue(pairs.stream().allMatch(row -> row.get("other").equals("zoom-out")));
    assertEquals(2 * 2, rows(out, "improvement.csv", row -> true).size());
    Path other = folder.resolve("other");
    run(other, 2, "zoom-out,sarsa", "--steps", 5, "--reference", "sarsa");
    assertTrue(
        rows(other, "pairs.csv", row -> true).stream()
            .allMatch(row -> row.get("policy").equals("zoom-out")));
  }

  @Test
  void rejectsReferenceThatIsNotCompared() {
    Cli cli = run(folder.resolve("none"), 2, "zoom-out,sarsa", "--reference", "tracker");
    assertEquals(2, cli.exit());
    assertEquals(1, cli.err().lines().count(), cli.err());
    assertTrue(cli.err().contains("--reference is 'tracker', expected one of"), cli.err());
  }

  @Test
  void profileNeverRises() throws IOException {
    List<Map<String, String>> rows = rows(out, "profile.csv", CompareStatisticsTest::sarsaHifi);
    assertEquals(101, rows.size());
    assertEquals(1, number(rows.get(0), "share"));
    for (int i = 1; i < rows.size(); i++) {
      assertTrue(number(rows.get(i), "share") <= number(rows.get(i - 1), "share"));
    }
    assertTrue(Files.size(out.resolve("profile.svg")) > 1000);
  }

  @Test
  void latexTablesHaveNumbersOfTerminalAndNamesOfFigures() throws IOException {
    Path paper = folder.resolve("paper");
    Object[] options = {"--details", "--steps", 60, "--latex", "--label", "zoom-out=Always wide"};
    Cli cli = run(paper, 3, "zoom-out,one-hop:nodes=50", options);
    List<String> lines = Files.readAllLines(paper.resolve("summary.tex"));
    assertEquals(
        2,
        lines.stream()
            .filter(
                line ->
                    line.equals("\\begin{tabular}{lllrrr}")
                        || line.equals("\\begin{tabular}{llrr}"))
            .count());
    List<String> rows = lines.stream().filter(line -> line.endsWith(" \\\\")).toList();
    assertEquals(1 + 2 * 2 * 3 + 1 + 2 * 2, rows.size());
    String row = rows.stream().filter(line -> line.contains("Always wide")).findFirst().get();
    for (String cell : row.replace(" \\\\", "").split(" & Always wide & ")[1].split(" & ")) {
      assertTrue(cli.out().contains(cell), cell);
    }
    assertTrue(rows.stream().anyMatch(line -> line.contains("& ORB linear & one-hop, nodes 50 &")));
    assertTrue(lines.stream().noneMatch(line -> line.contains("hifi:orb-lin")));
  }

  @Test
  void picturesHaveRequestedWidth() throws IOException {
    Path print = folder.resolve("print");
    run(print, 2, "zoom-out,sarsa", "--steps", 30, "--figure-width", "88mm");
    for (String name : List.of("proportion", "profile", "coverage", "k_min-lattice-random")) {
      String svg = Files.readString(print.resolve(name + ".svg"));
      assertTrue(svg.contains("width=\"88mm\""), name);
    }
    String svg = Files.readString(print.resolve("proportion.svg"));
    assertFalse(svg.contains("Proportion of the optimum"), "a title that captions have");
    assertTrue(svg.contains("ORB linear"), "names for people");
    Cli wrong = run(print, 2, "zoom-out", "--figure-width", "3in");
    assertEquals(2, wrong.exit());
    assertTrue(wrong.err().contains("--figure-width is '3in', expected "), wrong.err());
  }

  @Test
  void picturesHaveLabelsAndColoursOfUser() throws IOException {
    Path own = folder.resolve("own");
    String[] style = {"--palette", "#123456,#654321", "--label", "sarsa=Our method"};
    Cli cli = run(own, 2, "zoom-out,sarsa", "--steps", 30, style[0], style[1], style[2], style[3]);
    assertEquals(0, cli.exit(), cli.err());
    String svg = Files.readString(own.resolve("profile.svg"));
    assertTrue(svg.contains("Our method") && !svg.contains("sarsa"));
    String page = Files.readString(own.resolve("report.html"));
    assertTrue(page.contains("#123456") && page.contains("#654321"));
    assertTrue(page.contains("{\"sarsa\":\"Our method\"}"));
  }

  @Test
  void editedStyleFileDrawsFiguresAgain() throws IOException {
    Path out = folder.resolve("edited");
    String label = "sarsa=Our method";
    assertEquals(0, run(out, 2, "zoom-out,sarsa", "--steps", 30, "--label", label).exit());
    Path style = folder.resolve("edited.json");
    String text = Files.readString(out.resolve("style.json"));
    Files.writeString(style, text.replace("Our method", "Theirs").replace("#d55e00", "#123456"));
    Cli cli = run(out, 2, "zoom-out,sarsa", "--steps", 30, "--resume", "--style", style);
    assertEquals(0, cli.exit(), cli.err());
    String svg = Files.readString(out.resolve("profile.svg"));
    assertTrue(svg.contains("Theirs") && !svg.contains("Our method"));
    assertTrue(Files.readString(out.resolve("report.html")).contains("#123456"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          {"colours": {"sarsa": "red"}} | :1:23: sarsa is 'red', expected a colour such as #0072b2
          {"colours": ["#0072b2"]} | :1:13: expected colours by policy
          {"labels": {"sarsa": 3}} | :1:22: sarsa is '3', expected a text
          {"labels": []} | :1:12: expected texts by name
          {"fonts": 9} | :1:11: fonts is unknown, expected labels or colours
          {"labels": | the file ends too early
          """)
  void rejectsInvalidStyleFile(String text, String message) throws IOException {
    Path style = Files.writeString(folder.resolve("wrong.json"), text);
    assertRejected(message, "--style", style.toString());
  }

  @Test
  void rejectsStyleThatNamesNothing() {
    assertRejected("--palette is 'nice', expected bright, grey or colours", "--palette", "nice");
    assertRejected("--palette is '#12', expected bright", "--palette", "#12");
    assertRejected("--label is 'tracker=T', expected NAME=TEXT for", "--label", "tracker=T");
    assertRejected("--label is 'sarsa', expected NAME=TEXT for one of", "--label", "sarsa");
  }

  private static void assertRejected(String message, String option, String value) {
    Cli cli = run(folder.resolve("rejected"), 2, "zoom-out,sarsa", option, value);
    assertEquals(2, cli.exit());
    assertEquals(1, cli.err().lines().count(), cli.err());
    assertTrue(cli.err().contains(message), cli.err());
  }

  private static boolean sarsaHifi(Map<String, String> row) {
    return row.get("policy").equals("sarsa") && row.get("detection").equals("hifi:orb-lin");
  }

  private static boolean sameCase(Map<String, String> first, Map<String, String> second) {
    return Stream.of("scenario", "detection", "policy")
        .allMatch(name -> first.get(name).equals(second.get(name)));
  }

  /** A figure of a policy's runs, by scenario, detection and seed. */
  private static Map<String, Double> metric(Path out, String metric, String policy)
      throws IOException {
    Map<String, Double> values = new HashMap<>();
    for (Map<String, String> row :
        rows(
            out,
            "metrics.csv",
            row -> row.get("metric").equals(metric) && row.get("policy").equals(policy))) {
      String run = row.get("scenario") + "," + row.get("detection") + "," + row.get("seed");
      values.put(run, number(row, "value"));
    }
    return values;
  }

  private static double number(Map<String, String> row, String column) {
    return row.get(column).isEmpty() ? Double.NaN : Double.parseDouble(row.get(column));
  }

  private static List<Map<String, String>> rows(
      Path out, String file, Predicate<Map<String, String>> wanted) throws IOException {
    List<String> lines = Files.readAllLines(out.resolve(file));
    String[] columns = lines.get(0).split(",");
    List<Map<String, String>> rows = new ArrayList<>();
    for (String line : lines.subList(1, lines.size())) {
      String[] cells = line.split(",", -1);
      Map<String, String> row = new HashMap<>();
      Arrays.setAll(cells, i -> row.merge(columns[i], cells[i], (a, b) -> b));
      if (wanted.test(row)) {
        rows.add(row);
      }
    }
    return rows;
  }

  private static Cli run(Path out, int seeds, String policies, Object... more) {
    return Cli.run(
        Stream.concat(
                Stream.of(
                    "compare",
                    Cli.scenario("lattice-random"),
                    Cli.scenario("cluster-random"),
                    "--policies",
                    policies,
                    "--repeat",
                    seeds,
                    "--out",
                    out),
                Arrays.stream(more))
            .toArray());
  }
}
