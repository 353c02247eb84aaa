package org.hificamsim.agents.choice;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.hificamsim.agents.choice.Utility.Reading;
import org.hificamsim.agents.temporal.TemporalDifferenceZoomPolicy;
import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.AllocatedBytes;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.registry.Options;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class UtilityTest {
  /**
   * Returns a network of three cameras; the first one detects three targets, which 1, 2 and 3
   * cameras detect.
   */
  private static ToyNetwork network(String objective) {
    ToyNetwork network = new ToyNetwork(4, 1, 1, 1).scoredBy(Objective.parse(objective));
    network.see(0, 0, 0, 1, 2).see(1, 0, 1, 2).see(2, 0, 2);
    network.observe();
    return network;
  }

  @ParameterizedTest
  @CsvSource({
    "kmin, objective, 3",
    "kmin, count, 3",
    "kmin, difference, 1.8333333333333333",
    "covered:k=1, objective, 1",
    "covered:k=1, count, 3",
    "covered:k=2, objective, 1",
    "covered:k=4, objective, 0",
    "sum:cap=2, objective, 2",
    "sum:cap=3, difference, 3",
    "lexicographic, objective, 1.8333333333333333"
  })
  void isTheCountOrTheShareOfTheObjective(String objective, String utility, double expected) {
    ToyNetwork network = network(objective);
    Reading reading = Utility.from(Options.parse("policy", "utility=" + utility));
    assertEquals(expected, new Utility(reading, network.objective()).compute(network, 0), 1e-15);
  }

  @ParameterizedTest
  @ValueSource(strings = {"covered:k=1", "covered:k=2", "sum:cap=1", "sum:cap=2"})
  void differenceIsTheScoreLostWithoutTheCamera(String text) {
    SplittableRandom random = new SplittableRandom(3);
    for (int trial = 0; trial < 300; trial++) {
      ToyNetwork network = new ToyNetwork(5, 1, 1, 1, 1).scoredBy(Objective.parse(text));
      for (int camera = 0; camera < 4; camera++) {
        network.see(camera, 0, random.ints(0, 5).limit(random.nextInt(5)).distinct().toArray());
      }
      network.observe();
      double utility = new Utility(Reading.OBJECTIVE, network.objective()).compute(network, 2);
      double targets = text.startsWith("covered") ? 5 : 1;
      double score = network.score();
      network.switchCamera(2, false);
      network.observe();
      assertEquals(score - network.score(), utility / targets, 1e-12);
      assertEquals(0, new Utility(Reading.OBJECTIVE, network.objective()).compute(network, 2));
    }
  }

  @Test
  void learnerIsRewardedByDifferenceUnlessOptionIsCount() {
    ToyNetwork network = network("covered:k=1");
    TemporalDifferenceZoomPolicy counting =
        begin(network, "reward=literal,utility=count,state=none");
    TemporalDifferenceZoomPolicy sharing = begin(network, "reward=literal,state=none");
    for (int step = 0; step < 4; step++) {
      network.step(counting);
      network.switchCamera(2, step % 2 == 0);
    }
    assertTrue(counting.q().value(0, 0, 0) == 0, "three targets at every step");
    network.switchCamera(1, false);
    network.switchCamera(2, false);
    for (int step = 0; step < 3; step++) {
      network.step(sharing);
      network.switchCamera(1, step == 0);
    }
    network.step(sharing);
    assertFalse(
        sharing.q().value(0, 0, 0) == 0,
        "three targets that only this camera detects, then fewer, then three again");
  }

  private static TemporalDifferenceZoomPolicy begin(ToyNetwork network, String options) {
    return network.begin(TemporalDifferenceZoomPolicy.sarsa(Options.parse("sarsa", options)), 1);
  }

  @Test
  void allocatesNothing() {
    ToyNetwork network = network("covered:k=2");
    Utility utility = new Utility(Reading.OBJECTIVE, network.objective());
    assertEquals(
        0, AllocatedBytes.fewest(() -> AllocatedBytes.by(() -> utility.compute(network, 0))));
  }
}
