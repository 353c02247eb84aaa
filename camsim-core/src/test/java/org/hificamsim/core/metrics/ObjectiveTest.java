package org.hificamsim.core.metrics;

import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ObjectiveTest {
  @ParameterizedTest
  @ValueSource(strings = {"kmin", "covered:k=1", "covered:k=12", "lexicographic", "sum:cap=3"})
  void parsesItsOwnText(String text) {
    assertEquals(text, Objective.parse(text).text());
  }

  @Test
  void helpListsAllObjectivesWithDefaults() {
    String choices =
        Objective.objectives().names().stream()
            .map(name -> Objective.parse(name).text())
            .collect(joining("|"));
    assertEquals(choices, Objective.CHOICES);
  }

  @Test
  void optionsHaveDefaults() {
    assertEquals(new Objective.Covered(1), Objective.parse("covered"));
    assertEquals(new Objective.Sum(3), Objective.parse("sum"));
    assertEquals(Objective.kMin(), Objective.parse("kmin"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "most | unknown objective 'most', expected one of",
        "covered:k=0 | objective covered: k is '0', expected a whole number from 1 to",
        "sum:cap=x | objective sum: cap is 'x', expected a whole number from 1 to",
        "kmin:k=2 | objective kmin: unknown option 'k=2', expected no options",
        "covered:cap=2 | objective covered: unknown option 'cap=2', expected one of k",
      })
  void rejectsInvalidObjectives(String text, String expected) {
    InputException fault = assertThrows(InputException.class, () -> Objective.parse(text));
    assertTrue(fault.getMessage().contains(expected), fault.getMessage());
  }

  @Property
  void scoresEqualTheirDefinitions(
      @ForAll @Size(max = 9) List<@IntRange(min = -1, max = 5) Integer> coverage,
      @ForAll @IntRange(min = 1, max = 4) int number) {
    int[] k = coverage.stream().mapToInt(Integer::intValue).toArray();
    int[] present = Arrays.stream(k).filter(count -> count >= 0).toArray();
    int divisor = Math.max(1, present.length);
    double enough = Arrays.stream(present).filter(count -> count >= number).count();
    int[] coverable = Arrays.stream(present).filter(count -> count != 2).toArray();
    assertEquals(Arrays.stream(present).min().orElse(0), score("kmin", k));
    assertEquals(enough / divisor, score("covered:k=" + number, k));
    assertEquals(
        Arrays.stream(present).map(count -> Math.min(count, number)).sum(),
        score("sum:cap=" + number, k));
    assertEquals(Arrays.stream(coverable).min().orElse(0), score("lexicographic", k));
  }

  @Test
  void scoresRangeOfTargetsIndependently() {
    int[] k = {0, 9, 3, 1, 2, 9, 0};
    assertEquals(1, Objective.parse("kmin").score(k, 2, 5));
    assertEquals(2 / 3.0, Objective.parse("covered:k=2").score(k, 2, 5));
    assertEquals(5, Objective.parse("sum:cap=2").score(k, 2, 5));
    assertEquals(1, Objective.parse("lexicographic").score(k, 2, 5));
  }

  @Test
  void scoresZeroWithoutTargets() {
    for (String text : List.of("kmin", "covered", "lexicographic", "sum")) {
      assertEquals(0, score(text), text);
      assertEquals(0, score(text, -1, -1), text);
    }
  }

  /** The score for one k per target, -1 if absent; targets with k = 2 are not coverable. */
  private static double score(String objective, int... k) {
    StepCoverage coverage = new StepCoverage(Objective.parse(objective));
    coverage.measure(targets(1, 1, 1, 1)); // an earlier step
    coverage.measureScore(targets(1, 1, 1, 1));
    coverage.measure(targets(k));
    coverage.measureScore(targets(k));
    return coverage.score();
  }

  private static CoverableTargets targets(int... k) {
    return new CoverableTargets() {
      @Override
      public void markCoverable(boolean[] coverable) {
        for (int target = 0; target < k.length; target++) {
          coverable[target] = k[target] >= 0 && k[target] != 2;
        }
      }

      @Override
      public int targets() {
        return k.length;
      }

      @Override
      public boolean present(int target) {
        return k[target] >= 0;
      }

      @Override
      public int coverage(int target) {
        return k[target];
      }
    };
  }
}
