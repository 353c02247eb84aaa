package org.hificamsim.agents.bandit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.agents.CoveragePolicies;
import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that apply to all bandits. */
class BanditsTest {
  private final Registry<ZoomPolicy> registry = CoveragePolicies.register(new Registry<>("policy"));

  @ParameterizedTest
  @ValueSource(strings = {"epsilon-greedy", "softmax:temperature=0.000001", "ucb1"})
  void everyCameraFindsItsBestView(String bandit) {
    int[] best = {0, 1, 2};
    ToyNetwork network = new ToyNetwork(3, 3, 2, 4);
    for (int camera = 0; camera < 3; camera++) {
      network.see(camera, best[camera], 0, 1, 2);
    }
    ZoomPolicy policy = network.begin(registry.create(bandit), 1);
    int[] times = new int[3];
    for (int step = 0; step < 2_000; step++) {
      network.step(policy);
      for (int camera = 0; step >= 1_000 && camera < 3; camera++) {
        times[camera] += network.view(camera) == best[camera] ? 1 : 0;
      }
    }
    for (int camera = 0; camera < 3; camera++) {
      assertTrue(times[camera] > 800, "camera %s: %s".formatted(camera, times[camera]));
    }
  }

  /** Another camera detects one of two targets, which then counts half. */
  @ParameterizedTest
  @CsvSource({
    "epsilon-greedy, count, 2",
    "epsilon-greedy, difference, 1.5",
    "softmax, count, 2",
    "softmax, difference, 1.5",
    "ucb1, count, 2",
    "ucb1, difference, 1.5",
  })
  void isRewardedByTheChosenUtility(String bandit, String utility, double reward) {
    ToyNetwork network = new ToyNetwork(2, 1, 1).see(0, 0, 0, 1).see(1, 0, 0);
    ZoomPolicy policy = network.begin(registry.create(bandit + ":utility=" + utility), 1);
    network.step(policy);
    network.step(policy);
    double[] means = new double[1];
    double[] pulls = new double[1];
    policy.estimates(0, means, pulls);
    assertEquals(reward, means[0]);
    assertEquals(2, pulls[0]);
  }
}
