package org.hificamsim.network.bandit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Tests bandits by the formulas of behaviour 9.3, computed from lists of all results. */
class BanditAlgorithmTest {
  private static final double EPSILON = 0.25;
  private static final int ROUNDS = 400;

  /** The arms of a bandit, and a full list of their results. */
  private static final class History {
    private final Arms arms = new Arms(new Random(9));
    private final double[] first = new Random(9).doubles(Arms.COUNT).map(d -> d / 1e6).toArray();
    private final List<List<Double>> results = new ArrayList<>();
    private final int[] counts = new int[Arms.COUNT];
    private final int[] chosen = new int[Arms.COUNT];

    History() {
      Arrays.fill(counts, 1);
      IntStream.range(0, Arms.COUNT).forEach(arm -> results.add(new ArrayList<>()));
    }

    void reward(int arm, double amount) {
      arms.reward(arm, amount);
      counts[arm]++;
      for (int candidate = 0; candidate < Arms.COUNT; candidate++) {
        results.get(candidate).add(candidate == arm ? amount : 0.0);
      }
    }

    void choose(int arm) {
      arms.choose(arm);
      chosen[arm]++;
    }

    double mean(int arm) {
      return (first[arm] + results.get(arm).stream().mapToDouble(r -> r).sum()) / counts[arm];
    }

    double deviation(int arm) {
      double mean = mean(arm);
      return Math.sqrt(
          results.get(arm).stream().mapToDouble(r -> (r - mean) * (r - mean)).average().orElse(0));
    }

    double log() {
      return Math.log(Arrays.stream(counts).sum());
    }
  }

  /** Asserts each choice of an algorithm, with rewards around 0.3 and higher ones for arm 2. */
  private static void assertChoosesBest(
      BanditAlgorithm algorithm, Function<History, IntToDoubleFunction> value) {
    History history = new History();
    SplittableRandom random = new SplittableRandom(4);
    Set<Integer> seen = new HashSet<>();
    for (int round = 0; round < ROUNDS; round++) {
      int arm = algorithm.choose(history.arms, EPSILON, null);
      assertEquals(best(value.apply(history)), arm, "round " + round);
      history.choose(arm);
      history.reward(arm, random.nextDouble(-0.2, 0.8) + (arm == 2 ? 0.2 : 0));
      seen.add(arm);
    }
    assertEquals(Arms.COUNT, seen.size(), "arms that were tried");
  }

  private static int best(IntToDoubleFunction value) {
    int best = 0;
    for (int arm = 1; arm < Arms.COUNT; arm++) {
      best = value.applyAsDouble(arm) > value.applyAsDouble(best) ? arm : best;
    }
    return best;
  }

  @Test
  void ucb1ChoosesBestUpperBound() {
    assertChoosesBest(
        BanditAlgorithm.UCB1,
        history -> arm -> history.mean(arm) + Math.sqrt(2 * history.log() / history.counts[arm]));
  }

  @Test
  void ucbTunedLimitsVarianceToOneQuarter() {
    assertChoosesBest(
        BanditAlgorithm.UCB_TUNED,
        history ->
            arm -> {
              double share = history.log() / history.counts[arm];
              double bound = history.deviation(arm) + Math.sqrt(2 * share);
              return history.mean(arm) + Math.sqrt(share * Math.min(0.25, bound));
            });
  }

  @Test
  void ucbTunedPrefersLargerSpreadIfMeansAreEqual() {
    History history = new History();
    for (int round = 0; round < 3000; round++) {
      double spread = round % Arms.COUNT == 4 ? 0.48 : 0;
      history.reward(round % Arms.COUNT, round % 4 < 2 ? 0.02 + spread : 0.02 - spread);
    }
    double share = history.log() / history.counts[4];
    assertTrue(history.deviation(4) + Math.sqrt(2 * share) > 0.25);
    assertTrue(history.deviation(0) + Math.sqrt(2 * share) < 0.25);
    assertEquals(4, BanditAlgorithm.UCB_TUNED.choose(history.arms, EPSILON, null));
  }

  @Test
  void ucb2WeighsNumberOfChoices() {
    History history = new History();
    for (int round = 0; round < 200; round++) {
      int arm = BanditAlgorithm.UCB2.choose(history.arms, EPSILON, null);
      assertEquals(best(candidate -> ucb2(history, candidate)), arm, "round " + round);
      history.choose(arm);
      history.reward(arm, 0.1 * arm);
    }
  }

  private static double ucb2(History history, int arm) {
    double tau = Math.ceil(Math.pow(1 + EPSILON, history.chosen[arm]));
    double log = Math.log(Math.E * history.counts[arm] / tau);
    return history.mean(arm) + Math.sqrt((1 + EPSILON) * log / (2 * tau));
  }

  @Test
  void ucb2KeepsArmLongerEachTime() {
    BanditParameters parameters = new BanditParameters(0.5, 0, 0, 0, 1);
    List<Integer> intervals = new ArrayList<>();
    for (int chosen = 0; chosen < 6; chosen++) {
      intervals.add(BanditAlgorithm.UCB2.interval(chosen, parameters));
    }
    assertEquals(List.of(1, 1, 1, 2, 2, 4), intervals, "steps between 1 2 3 4 6 8 12");
    assertEquals(1, BanditAlgorithm.UCB1.interval(5, parameters));
  }

  @Test
  void softMaxDrawsArmsByExponentialOfMean() {
    History history = new History();
    history.reward(1, 1.0);
    history.reward(5, -0.4);
    double[] weights =
        IntStream.range(0, Arms.COUNT)
            .mapToDouble(arm -> Math.exp(history.mean(arm) / EPSILON))
            .toArray();
    double sum = Arrays.stream(weights).sum();
    int[] drawn = new int[Arms.COUNT];
    Random random = new Random(3);
    for (int i = 0; i < 20_000; i++) {
      drawn[BanditAlgorithm.SOFT_MAX.choose(history.arms, EPSILON, random)]++;
    }
    for (int arm = 0; arm < Arms.COUNT; arm++) {
      assertEquals(weights[arm] / sum, drawn[arm] / 20_000.0, 0.01, "arm " + arm);
    }
  }

  @Test
  void epsilonGreedyExploresOrChoosesBestMean() {
    History history = new History();
    history.reward(3, 1.0);
    Random random = new Random(7);
    Random same = new Random(7);
    for (int i = 0; i < 200; i++) {
      int expected = same.nextDouble() < EPSILON ? same.nextInt(Arms.COUNT) : 3;
      assertEquals(expected, BanditAlgorithm.EPSILON_GREEDY.choose(history.arms, EPSILON, random));
    }
  }

  @Test
  void epsilonGreedyAndUcb1IgnoreBetaAndGamma() {
    BanditParameters all = new BanditParameters(0.1, 0.2, 0.3, 0.4, 5);
    BanditParameters dropped = new BanditParameters(0.1, 0.2, 0, 0, 5);
    assertEquals(dropped, all.usedBy(BanditAlgorithm.EPSILON_GREEDY));
    assertEquals(dropped, all.usedBy(BanditAlgorithm.UCB1));
    assertEquals(all, all.usedBy(BanditAlgorithm.SOFT_MAX));
  }
}
