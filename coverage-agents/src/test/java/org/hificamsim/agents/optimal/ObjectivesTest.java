package org.hificamsim.agents.optimal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.InputException;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.ProvingZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests upper bounds under objectives other than k_min. */
class ObjectivesTest {
  private static final int VIEWS = 3;

  @ParameterizedTest
  @ValueSource(strings = {"kmin", "covered:k=1", "covered:k=2", "sum:cap=2", "lexicographic"})
  void optimalAndOneHopReachTheBestScore(String text) {
    SplittableRandom random = new SplittableRandom(7);
    for (int trial = 0; trial < 400; trial++) {
      ToyNetwork network = random(random).scoredBy(Objective.parse(text));
      assertReaches(network, new OptimalZoomPolicy(1_000_000), VIEWS);
      assertReaches(network, new OneHopZoomPolicy(Options.none("one-hop")), 1);
    }
  }

  private static void assertReaches(ToyNetwork network, ProvingZoomPolicy policy, int hop) {
    network.begin(policy, 1);
    double best = best(network, network.currentViews(), hop, 0);
    network.decide(policy);
    network.observe();
    assertEquals(best, network.score());
    assertEquals(0, policy.unprovenSteps());
    assertEquals(0, policy.gap());
  }

  /** Returns the best score of all views at most {@code hop} away from the present ones. */
  private static double best(ToyNetwork network, int[] before, int hop, int camera) {
    if (camera == before.length) {
      network.observe();
      return network.score();
    }
    double best = 0;
    for (int view = 0; view < VIEWS; view++) {
      if (Math.abs(view - before[camera]) <= hop) {
        network.setView(camera, view);
        best = Math.max(best, best(network, before, hop, camera + 1));
      }
    }
    network.setView(camera, before[camera]);
    return best;
  }

  private static ToyNetwork random(SplittableRandom random) {
    int targets = 1 + random.nextInt(5);
    ToyNetwork network = new ToyNetwork(targets, VIEWS, VIEWS, VIEWS, VIEWS);
    for (int camera = 0; camera < network.cameras(); camera++) {
      for (int view = 0; view < VIEWS; view++) {
        network.see(
            camera, view, random.ints(0, targets).limit(random.nextInt(4)).distinct().toArray());
      }
    }
    network.switchCamera(random.nextInt(4), random.nextBoolean());
    network.showTarget(random.nextInt(targets), random.nextBoolean());
    return network;
  }

  @Test
  void optimalExpectedRejectsOtherObjectives() {
    ToyNetwork network = new ToyNetwork(1, VIEWS).scoredBy(Objective.parse("covered"));
    InputException error =
        assertThrows(
            InputException.class,
            () ->
                network.begin(
                    new OptimalExpectedZoomPolicy(Options.parse("optimal-expected", "nodes=1")),
                    1));
    assertTrue(
        error.getMessage().startsWith("objective is covered:k=1, expected kmin with policy"),
        error.getMessage());
  }
}
