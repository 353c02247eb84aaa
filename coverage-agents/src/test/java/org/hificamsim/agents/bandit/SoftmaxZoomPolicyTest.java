package org.hificamsim.agents.bandit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.registry.Options;
import org.junit.jupiter.api.Test;

class SoftmaxZoomPolicyTest {
  private final ToyNetwork network =
      new ToyNetwork(4, 4).see(0, 0, 0).see(0, 1, 0, 1, 2).see(0, 3, 0, 1);

  @Test
  void drawsViewsInProportionToTheirWeights() {
    double temperature = 1.5;
    SoftmaxZoomPolicy policy =
        network.begin(
            new SoftmaxZoomPolicy(Options.parse("softmax", "temperature=" + temperature)), 1);
    int[] times = afterLearning(policy, 100_000);
    double[] means = {1, 3, 0, 2};
    double sum = 0;
    for (double mean : means) {
      sum += Math.exp(mean / temperature);
    }
    double chiSquare = 0;
    for (int view = 0; view < 4; view++) {
      double expected = 100_000 * Math.exp(means[view] / temperature) / sum;
      chiSquare += Math.pow(times[view] - expected, 2) / expected;
    }
    assertTrue(chiSquare < 16.3, "chi-square with 3 degrees of freedom is " + chiSquare);
  }

  @Test
  void tinyTemperatureTakesOnlyTheBestView() {
    SoftmaxZoomPolicy policy =
        network.begin(new SoftmaxZoomPolicy(Options.parse("softmax", "temperature=1e-6")), 1);
    assertEquals(1_000, afterLearning(policy, 1_000)[1]);
  }

  @Test
  void hugeTemperatureDrawsAllViewsEquallyOften() {
    SoftmaxZoomPolicy policy =
        network.begin(new SoftmaxZoomPolicy(Options.parse("softmax", "temperature=1e6")), 1);
    for (int times : afterLearning(policy, 40_000)) {
      assertEquals(10_000, times, 400);
    }
  }

  /** Uses each view once, so that averages are exact, and then counts the views that are drawn. */
  private int[] afterLearning(SoftmaxZoomPolicy policy, int steps) {
    for (int view = 0; view < 4; view++) {
      network.setView(0, view);
      network.observe();
      policy.learn(network);
    }
    int[] times = new int[4];
    for (int step = 0; step < steps; step++) {
      network.step(policy);
      times[network.view(0)]++;
    }
    return times;
  }
}
