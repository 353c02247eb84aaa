package org.hificamsim.network.bandit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.SortedMap;
import java.util.SplittableRandom;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests bandits without a network. */
class BanditSolverTest {
  private static BanditSolver solver(BanditAlgorithm algorithm, int interval) {
    return new BanditSolver(
        algorithm, new BanditParameters(0.1, 1, 0.5, 0, interval), new Random(1));
  }

  /** Leaves out UCB2, which in CamSim uses the count of one arm only, and finds no best arm. */
  @ParameterizedTest
  @EnumSource(
      value = BanditAlgorithm.class,
      names = {"FULL_RANDOM", "UCB2"},
      mode = EnumSource.Mode.EXCLUDE)
  void choosesBestArmMostOften(BanditAlgorithm algorithm) {
    BanditSolver solver = solver(algorithm, 1);
    int best = 0;
    for (int step = 0; step < 3000; step++) {
      int arm = solver.select();
      best += arm == 4 ? 1 : 0;
      solver.feed(arm == 4 ? 1 : 0.2, 0);
    }
    assertTrue(best > 1500, best + " of 3000");
  }

  @Test
  void keepsArmForInterval() {
    BanditSolver solver = solver(BanditAlgorithm.FULL_RANDOM, 5);
    int first = solver.select();
    solver.feed(0, 0);
    int arm = solver.select();
    for (int step = 0; step < 4; step++) {
      solver.feed(0, 0);
      assertEquals(arm, solver.select());
    }
    assertTrue(first >= 0 && first < Arms.COUNT);
    assertEquals(2, solver.arms().count(first));
  }

  @Test
  void meanAndSpreadEqualThoseOfListedResults() {
    Arms arms = new Arms(new Random(0));
    List<Double> results = new ArrayList<>();
    SplittableRandom random = new SplittableRandom(2);
    for (int i = 0; i < 500; i++) {
      int arm = random.nextInt(Arms.COUNT);
      double reward = random.nextDouble(-1, 2);
      arms.reward(arm, reward);
      results.add(arm == 3 ? reward : 0.0);
      double mean = arms.mean(3);
      double squares = results.stream().mapToDouble(r -> (r - mean) * (r - mean)).sum();
      assertEquals(Math.sqrt(squares / results.size()), arms.deviation(3), 1e-12);
    }
  }

  @Test
  void shareBelowCountsStrictlySmallerEarlierValues() {
    SortedMap<Double, Integer> counts = new TreeMap<>();
    assertEquals(0, BanditSolver.shareBelow(5, counts));
    for (double value = 0; value < 25; value++) {
      counts.put(value, 4);
    }
    assertEquals(0.4, BanditSolver.shareBelow(10, counts));
    assertEquals(0, BanditSolver.shareBelow(0, counts));
    assertEquals(1, BanditSolver.shareBelow(25, counts));
  }
}
