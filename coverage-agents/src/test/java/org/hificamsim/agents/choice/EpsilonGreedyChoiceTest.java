package org.hificamsim.agents.choice;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.hificamsim.agents.toy.ToyNetwork;
import org.junit.jupiter.api.Test;

class EpsilonGreedyChoiceTest {
  private static final int DRAWS = 100_000;

  @Test
  void exploringOtherLevelsSpreadsEpsilonEvenlyOverThem() {
    assertShares(Exploration.OTHER, 0.025, 0.9);
  }

  @Test
  void exploringAnyLevelIncludesTheBest() {
    assertShares(Exploration.ANY, 0.02, 0.92);
  }

  @Test
  void aSingleLevelIsAlwaysTaken() {
    for (Exploration exploration : Exploration.values()) {
      assertEquals(0, exploration.draw(new SplittableRandom(1), 1, 0));
    }
  }

  @Test
  void epsilonDecaysDownToItsLeast() {
    EpsilonSchedule schedule = new EpsilonSchedule(0.4, 0.5, 0.15);
    assertEquals(0.2, schedule.next(0.4));
    assertEquals(0.15, schedule.next(0.2));
    assertEquals(0.15, schedule.next(0.15));
  }

  @Test
  void aLeastAboveTheStartHasNoEffect() {
    assertEquals(0.1, new EpsilonSchedule(0.1, 0.5, 0.3).next(0.1));
  }

  @Test
  void exploresLessOftenAsEpsilonDecays() {
    ToyNetwork network = new ToyNetwork(0, 5);
    EpsilonGreedyChoice choice =
        new EpsilonGreedyChoice(new EpsilonSchedule(1, 0.5, 0), Exploration.OTHER);
    choice.begin(network, new SplittableRandom(1));
    int explored = 0;
    for (int n = 0; n < 1_000; n++) {
      explored += choice.choose(0, 5, 2) != 2 ? 1 : 0;
    }
    assertTrue(explored >= 1 && explored < 10, "explored " + explored + " times");
  }

  @Test
  void tiesGoWhereTheyAreSaidToGo() {
    double[] values = {9, 1, 3, 3, 2};
    assertEquals(2, Ties.WIDEST.best(values, 1, 4));
    assertEquals(1, Ties.NARROWEST.best(values, 1, 4));
    double[] unbounded = {1, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
    assertEquals(2, Ties.WIDEST.best(unbounded, 0, 3));
    assertEquals(1, Ties.NARROWEST.best(unbounded, 0, 3));
  }

  private static void assertShares(Exploration exploration, double other, double best) {
    EpsilonGreedyChoice choice =
        new EpsilonGreedyChoice(new EpsilonSchedule(0.1, 1, 0), exploration);
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
