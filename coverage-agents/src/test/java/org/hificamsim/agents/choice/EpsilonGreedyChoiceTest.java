package org.hificamsim.agents.choice;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.registry.Options;
import org.junit.jupiter.api.Test;

class EpsilonGreedyChoiceTest {
  private static final int DRAWS = 100_000;

  @Test
  void exploringOtherViewsDrawsThemEquallyOften() {
    assertShares("other", 0.025, 0.9);
  }

  @Test
  void exploringAnyViewIncludesTheBest() {
    assertShares("any", 0.02, 0.92);
  }

  @Test
  void takesTheOnlyView() {
    for (String exploration : List.of("other", "any")) {
      EpsilonGreedyChoice choice = choice("epsilon=1,explore=" + exploration);
      choice.begin(new ToyNetwork(0, 1), new SplittableRandom(1));
      assertEquals(0, choice.choose(0, 1, 0));
    }
  }

  @Test
  void epsilonDecaysToItsMinimum() {
    assertEquals(List.of(0.4, 0.2, 0.15, 0.15), sharesExplored("0.4", "0.15"));
  }

  @Test
  void minimumAboveTheFirstEpsilonHasNoEffect() {
    assertEquals(List.of(0.1, 0.1, 0.1, 0.1), sharesExplored("0.1", "0.3"));
  }

  /** The share of many cameras that explore in each of the first four decisions, with decay 0.5. */
  private static List<Double> sharesExplored(String epsilon, String least) {
    int cameras = 40_000;
    EpsilonGreedyChoice choice =
        choice("epsilon=" + epsilon + ",epsilon-decay=0.5,epsilon-min=" + least);
    int[] views = new int[cameras];
    Arrays.fill(views, 2);
    choice.begin(new ToyNetwork(0, views), new SplittableRandom(1));
    List<Double> shares = new ArrayList<>();
    for (int n = 0; n < 4; n++) {
      int explored = 0;
      for (int camera = 0; camera < cameras; camera++) {
        explored += choice.choose(camera, 2, 1) == 0 ? 1 : 0;
      }
      shares.add(Math.round(explored * 20.0 / cameras) / 20.0);
    }
    return shares;
  }

  @Test
  void exploresLessOftenAsEpsilonDecays() {
    ToyNetwork network = new ToyNetwork(0, 5);
    EpsilonGreedyChoice choice = choice("epsilon=1,epsilon-decay=0.5");
    choice.begin(network, new SplittableRandom(1));
    int explored = 0;
    for (int n = 0; n < 1_000; n++) {
      explored += choice.choose(0, 5, 2) != 2 ? 1 : 0;
    }
    assertTrue(explored >= 1 && explored < 10, "explored " + explored + " times");
  }

  @Test
  void tiesGoToTheWidestOrNarrowestView() {
    double[] values = {9, 1, 3, 3, 2};
    assertEquals(2, Ties.WIDEST.best(values, 1, 4));
    assertEquals(1, Ties.NARROWEST.best(values, 1, 4));
    double[] unbounded = {1, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
    assertEquals(2, Ties.WIDEST.best(unbounded, 0, 3));
    assertEquals(1, Ties.NARROWEST.best(unbounded, 0, 3));
  }

  private static EpsilonGreedyChoice choice(String options) {
    return new EpsilonGreedyChoice(Options.parse("policy", options));
  }

  private static void assertShares(String exploration, double other, double best) {
    EpsilonGreedyChoice choice = choice("explore=" + exploration);
    choice.begin(new ToyNetwork(0, 5), new SplittableRandom(3));
    int[] times = new int[5];
    for (int n = 0; n < DRAWS; n++) {
      times[choice.choose(0, 5, 3)]++;
    }
    double chiSquare = 0;
    for (int view = 0; view < 5; view++) {
      double expected = DRAWS * (view == 3 ? best : other);
      chiSquare += Math.pow(times[view] - expected, 2) / expected;
    }
    assertTrue(chiSquare < 18.5, "chi-square with 4 degrees of freedom is " + chiSquare);
  }
}
