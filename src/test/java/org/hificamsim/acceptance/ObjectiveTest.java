package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the objective of steps: {@code --objective} and the attribute {@code objective}. */
class ObjectiveTest {
  private static final ObjectMapper JSON = new ObjectMapper();

  @TempDir Path folder;

  @Test
  void optionOverridesScenarioAndDefault() throws IOException {
    Path covered = scored("covered:k=2");
    assertEquals("kmin", run(Cli.scenario("ring-random")).get("objective").asText());
    assertEquals("covered:k=2", run(covered).get("objective").asText());
    JsonNode asked = run(covered, "--objective", "sum:cap=2");
    assertEquals("sum:cap=2", asked.get("objective").asText());
  }

  @Test
  void scoreOfRunIsSumOfSteps() throws IOException {
    JsonNode run = run(Cli.scenario("ring-random"), "--objective", "covered");
    assertEquals(30 * (1 - run.get("covered_0").asDouble()), run.get("score").asDouble(), 1e-9);
    JsonNode twice = run(Cli.scenario("ring-random"), "--objective", "covered:k=2");
    assertEquals(30 * twice.get("covered_k").asDouble(), twice.get("score").asDouble(), 1e-9);
    JsonNode kMin = run(Cli.scenario("ring-random"));
    assertEquals(kMin.get("performance"), kMin.get("score"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"covered:k=1", "covered:k=3", "sum:cap=2", "lexicographic"})
  void optimumAndBestFixedAreUpperBounds(String objective) throws IOException {
    Cli compare =
        compare(objective, "zoom-out,zoom-in,fixed:1,random,sarsa,ucb1,optimal,best-fixed");
    assertEquals(0, compare.exit(), compare.err());
    assertTrue(compare.out().contains("score [95%]"), compare.out());
    List<String> rows = Files.readAllLines(folder.resolve("results.csv"));
    double greatestScore = 0;
    double greatestFixedScore = 0;
    for (String row : rows.subList(1, rows.size())) {
      String[] cells = row.split(",");
      double score = Double.parseDouble(cells[11]);
      double optimum = Double.parseDouble(cells[9]);
      assertEquals(objective, cells[10]);
      assertTrue(score <= optimum + 1e-9, row);
      assertEquals(score / optimum, Double.parseDouble(cells[5]), 1e-9, row);
      greatestScore = Math.max(greatestScore, score);
      if (cells[2].startsWith("zoom") || cells[2].startsWith("fixed")) {
        greatestFixedScore = Math.max(greatestFixedScore, score);
      }
    }
    assertTrue(greatestFixedScore <= figure("best-fixed", "score"));
    assertEquals(greatestScore, figure("optimal", "score"));
    assertEquals(0, figure("optimal", "unproven_steps"));
    assertEquals(figure("optimal", "score"), figure("optimal", "score_bound"));
    assertEquals(
        figure("optimal", "score") / figure("best-fixed", "score"),
        figure("optimal", "value_of_adapting"),
        1e-9);
  }

  @Test
  void terminalTableHasNoScoreUnderKMin() {
    assertFalse(compare("kmin", "zoom-out").out().contains("score"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "run | most | unknown objective 'most', expected one of",
        "run | covered:k=0 | objective covered: k is '0', expected a whole number from 1",
        "compare | sum:k=2 | objective sum: unknown option 'k=2', expected one of cap",
      })
  void rejectsUnknownObjectives(String command, String objective, String expected) {
    Cli refused =
        Cli.run(command, Cli.scenario("ring-random"), "--objective", objective, "--out", folder);
    assertEquals(2, refused.exit());
    assertTrue(refused.err().contains(expected), refused.err());
  }

  @Test
  void optimalExpectedRejectsOtherObjectives() throws IOException {
    Path scenario = scored("covered:k=1");
    Cli run = Cli.run("run", scenario, "--policy", "optimal-expected", "--out", folder);
    assertEquals(2, run.exit());
    assertTrue(run.err().contains("objective is covered:k=1, expected kmin with"), run.err());
  }

  private Cli compare(String objective, String policies) {
    return Cli.run(words(objective, policies));
  }

  private Object[] words(String objective, String policies, Object... more) {
    List<Object> words =
        new ArrayList<>(
            List.of(
                "compare",
                Cli.scenario("cluster-random"),
                "--policies",
                policies,
                "--objective",
                objective,
                "--steps",
                30,
                "--repeat",
                2,
                "--out",
                folder));
    words.addAll(List.of(more));
    return words.toArray();
  }

  /** Returns the greatest value of all seeds. */
  private double figure(String policy, String name) throws IOException {
    return Files.readAllLines(folder.resolve("metrics.csv")).stream()
        .map(row -> row.split(","))
        .filter(cells -> cells[2].equals(policy) && cells[4].equals(name))
        .mapToDouble(cells -> Double.parseDouble(cells[5]))
        .max()
        .orElseThrow();
  }

  private Path scored(String objective) throws IOException {
    String file = Files.readString(Cli.scenario("ring-random"));
    Path scenario = folder.resolve("scored.xml");
    Files.writeString(
        scenario, file.replace("<simulation ", "<simulation objective=\"" + objective + "\" "));
    return scenario;
  }

  private JsonNode run(Path scenario, Object... more) throws IOException {
    List<Object> words =
        new ArrayList<>(
            List.of("run", scenario, "--policy", "ucb1", "--steps", 30, "--out", folder));
    words.addAll(List.of(more));
    Cli run = Cli.run(words.toArray());
    assertEquals(0, run.exit(), run.err());
    return JSON.readTree(Files.readString(folder.resolve("summary.json")));
  }
}
