package org.hificamsim.agents.baseline;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.agents.CoveragePolicies;
import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.registry.Registry;
import org.junit.jupiter.api.Test;

class BaselineZoomPolicyTest {
  private final ToyNetwork network = new ToyNetwork(1, 5, 3, 1);

  @Test
  void zoomOutTakesEachCamerasWidestLevel() {
    assertArrayEquals(
        new int[] {4, 2, 0},
        levelsAfter(new AheadZoomPolicy("zoom-out", PatrolZoomPolicy.Zoom.WIDEST)));
  }

  @Test
  void zoomInTakesTheNarrowestLevel() {
    assertArrayEquals(
        new int[] {0, 0, 0},
        levelsAfter(new AheadZoomPolicy("zoom-in", PatrolZoomPolicy.Zoom.NARROWEST)));
  }

  /** In view 0 all targets happen to be detected; in view 1 more are expected. */
  @Test
  void greedyUsesChancesAndNotLuck() {
    double[][] chances = {{0.4, 0.4}, {0.9, 0.1}, {0.2, 0.2}};
    ToyNetwork byChance =
        new ToyNetwork(2, 3) {
          @Override
          public boolean certain() {
            return false;
          }

          @Override
          public double chance(int camera, int view, int target) {
            return chances[view][target];
          }
        };
    byChance.see(0, 0, 0, 1);
    ZoomPolicy greedy = byChance.begin(new IndependentGreedyZoomPolicy(Options.none("greedy")), 1);
    byChance.decide(greedy);
    assertArrayEquals(new int[] {1}, byChance.currentViews());
  }

  @Test
  void oneFixedLevelAppliesToAllCameras() {
    assertArrayEquals(new int[] {0, 0, 0}, levelsAfter(new FixedZoomPolicy(Options.none("fixed"))));
  }

  @Test
  void fixedLevelsFollowTheCamerasOrder() {
    Registry<ZoomPolicy> registry = CoveragePolicies.register(new Registry<>("policy"));
    assertArrayEquals(new int[] {3, 1, 0}, levelsAfter(registry.create("fixed:3,1,0")));
  }

  @Test
  void rejectsFixedLevelThatACameraDoesNotHave() {
    ZoomPolicy policy = new FixedZoomPolicy(Options.parse("fixed", "3"));
    InputException error = assertThrows(InputException.class, () -> network.begin(policy, 1));
    assertEquals(
        "policy fixed: level of camera 'c1' is 3, expected 0 (narrowest) to 2 (widest)",
        error.getMessage());
  }

  @Test
  void rejectsInvalidNumberOfFixedLevels() {
    ZoomPolicy policy = new FixedZoomPolicy(Options.parse("fixed", "0,0"));
    InputException error = assertThrows(InputException.class, () -> network.begin(policy, 1));
    assertTrue(error.getMessage().contains("has 2 values, expected 1 for all cameras or 3"));
  }

  @Test
  void randomTakesEachLevelEquallyOften() {
    RandomZoomPolicy policy = network.begin(new RandomZoomPolicy(), 7);
    int[] times = new int[5];
    for (int step = 0; step < 50_000; step++) {
      network.step(policy);
      times[network.view(0)]++;
    }
    double chiSquare = 0;
    for (int count : times) {
      chiSquare += Math.pow(count - 10_000, 2) / 10_000;
    }
    assertTrue(chiSquare < 18.5, "chi-square with 4 degrees of freedom is " + chiSquare);
  }

  @Test
  void randomLevelsDoNotDependOnOtherCameras() {
    ToyNetwork other = new ToyNetwork(1, 5, 3, 1);
    other.switchCamera(0, false);
    RandomZoomPolicy policy = network.begin(new RandomZoomPolicy(), 7);
    RandomZoomPolicy otherPolicy = other.begin(new RandomZoomPolicy(), 7);
    for (int step = 0; step < 100; step++) {
      network.step(policy);
      other.step(otherPolicy);
      assertEquals(network.view(1), other.view(1));
    }
  }

  private int[] levelsAfter(ZoomPolicy policy) {
    network.step(network.begin(policy, 1));
    return network.currentViews();
  }
}
