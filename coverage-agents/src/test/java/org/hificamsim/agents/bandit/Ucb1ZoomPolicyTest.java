package org.hificamsim.agents.bandit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.registry.Options;
import org.junit.jupiter.api.Test;

class Ucb1ZoomPolicyTest {
  private final ToyNetwork network = new ToyNetwork(4, 3).see(0, 0, 0).see(0, 1, 0, 1, 2);

  @Test
  void usesEveryViewOnceFirst() {
    Ucb1ZoomPolicy policy = network.begin(new Ucb1ZoomPolicy(Options.parse("ucb1", "c=1")), 1);
    int[] order = new int[3];
    for (int step = 0; step < 3; step++) {
      network.step(policy);
      order[step] = network.view(0);
    }
    assertArrayEquals(new int[] {2, 1, 0}, order);
  }

  @Test
  void staysAtTheBestAverageWithoutExploration() {
    Ucb1ZoomPolicy policy = network.begin(new Ucb1ZoomPolicy(Options.parse("ucb1", "c=0")), 1);
    for (int step = 0; step < 50; step++) {
      network.step(policy);
      assertTrue(step < 3 || network.view(0) == 1);
    }
  }

  @Test
  void decidesByTheUpperConfidenceBound() {
    double c = 0.7;
    double[] means = {0.25, 0.75, 0};
    int[] pulls = {1, 1, 1};
    Ucb1ZoomPolicy policy = network.begin(new Ucb1ZoomPolicy(Options.parse("ucb1", "c=" + c)), 1);
    for (int step = 0; step < 3; step++) {
      network.step(policy);
    }
    for (int n = 3; n < 500; n++) {
      int best = 2;
      for (int view = 1; view >= 0; view--) {
        best = bound(c, means, pulls, n, view) > bound(c, means, pulls, n, best) ? view : best;
      }
      network.step(policy);
      assertEquals(best, network.view(0), "decision " + n);
      pulls[best]++;
    }
    assertTrue(pulls[1] > 300, "used the best view " + pulls[1] + " times");
  }

  private static double bound(double c, double[] means, int[] pulls, int n, int view) {
    return means[view] + c * Math.sqrt(StrictMath.log(n) / pulls[view]);
  }
}
