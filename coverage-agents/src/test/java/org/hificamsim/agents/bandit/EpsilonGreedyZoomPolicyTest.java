package org.hificamsim.agents.bandit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.agents.choice.Ties;
import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.registry.Options;
import org.junit.jupiter.api.Test;

class EpsilonGreedyZoomPolicyTest {
  private final ToyNetwork network = new ToyNetwork(3, 4);

  @Test
  void startsAtThePreferredView() {
    network.step(network.begin(greedy(0, Ties.WIDEST), 1));
    assertEquals(3, network.view(0));
    network.step(network.begin(greedy(0, Ties.NARROWEST), 1));
    assertEquals(0, network.view(0));
  }

  @Test
  void keepsADetectingViewWithoutExploring() {
    network.see(0, 3, 0).see(0, 1, 0, 1, 2);
    EpsilonGreedyZoomPolicy policy = network.begin(greedy(0, Ties.WIDEST), 1);
    for (int step = 0; step < 100; step++) {
      network.step(policy);
      assertEquals(3, network.view(0));
    }
  }

  @Test
  void findsTheBestViewByExploring() {
    network.see(0, 3, 0).see(0, 1, 0, 1, 2).see(0, 2, 1, 2);
    EpsilonGreedyZoomPolicy policy = network.begin(greedy(0.1, Ties.WIDEST), 1);
    int atBest = 0;
    for (int step = 0; step < 10_000; step++) {
      network.step(policy);
      atBest += network.view(0) == 1 ? 1 : 0;
    }
    assertTrue(atBest > 8_800 && atBest < 9_200, "at the best view in " + atBest + " steps");
  }

  @Test
  void averagesAllRewardsOfAView() {
    EpsilonGreedyZoomPolicy arms = network.begin(greedy(0, Ties.WIDEST), 1);
    for (int targets = 0; targets <= 3; targets++) {
      network.see(0, 3, java.util.stream.IntStream.range(0, targets).toArray());
      network.observe();
      arms.learn(network);
    }
    assertEquals(1.5, arms.means(0)[3]);
    assertEquals(4, arms.pulls(0)[3]);
    assertEquals(0, arms.means(0)[0]);
  }

  @Test
  void reportsAverageAndUseOfEachView() {
    network.see(0, 3, 0, 1);
    EpsilonGreedyZoomPolicy policy = network.begin(greedy(0, Ties.WIDEST), 1);
    network.step(policy);
    network.see(0, 3, 0);
    network.step(policy);
    double[] estimates = new double[4];
    double[] counts = new double[4];
    assertEquals("mean reward", policy.estimates(0, estimates, counts));
    assertArrayEquals(new double[] {Double.NaN, Double.NaN, Double.NaN, 1.5}, estimates);
    assertArrayEquals(new double[] {0, 0, 0, 2}, counts);
  }

  @Test
  void offlineCameraLearnsNothing() {
    EpsilonGreedyZoomPolicy arms = network.begin(greedy(0, Ties.WIDEST), 1);
    network.switchCamera(0, false);
    arms.learn(network);
    assertEquals(0, arms.pulls(0)[3]);
  }

  private static EpsilonGreedyZoomPolicy greedy(double epsilon, Ties ties) {
    String options = "epsilon=" + epsilon + ",ties=" + Spelling.of(ties);
    return new EpsilonGreedyZoomPolicy(Options.parse("epsilon-greedy", options));
  }
}
