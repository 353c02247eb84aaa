package org.hificamsim.agents.temporal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.hificamsim.agents.CoveragePolicies;
import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.junit.jupiter.api.Test;

class TemporalDifferenceZoomPolicyTest {
  private static final List<String> BOTH = List.of("sarsa", "q-learning");

  private final Registry<ZoomPolicy> registry = CoveragePolicies.register(new Registry<>("policy"));

  /**
   * A camera with two views: the wide one, which comes first, detects nothing, and the narrow one
   * two targets.
   */
  private final ToyNetwork network = new ToyNetwork(2, 2).see(0, 0, 0, 1);

  @Test
  void creditsTheActionThatLedToTheNewCount() {
    for (String name : BOTH) {
      TemporalDifferenceZoomPolicy policy =
          startPolicy(name + ":epsilon=0,alpha=0.5,gamma=0,ties=narrowest");
      start();
      network.step(policy);
      assertEquals(0, network.view(0));
      network.decide(policy);
      ActionValues values = policy.q();
      assertEquals(1, values.value(0, values.state(0, 1, 0), 0), "half of the two targets gained");
      assertEquals(0, values.value(0, values.state(0, 0, 2), 0));
    }
  }

  @Test
  void firstDecisionTeachesNothing() {
    for (String name : BOTH) {
      TemporalDifferenceZoomPolicy policy = startPolicy(name + ":alpha=1,ties=narrowest");
      network.setView(0, 0);
      network.observe();
      network.step(policy);
      for (int state = 0; state < 6; state++) {
        assertEquals(0, policy.q().value(0, state, 0));
        assertEquals(0, policy.q().value(0, state, 1));
      }
    }
  }

  @Test
  void sarsaUpdatesWithTheActionChosenNext() {
    TemporalDifferenceZoomPolicy policy =
        startPolicy("sarsa:epsilon=1,alpha=0.5,gamma=0.5,ties=narrowest");
    ActionValues values = forcedRound(policy);
    assertEquals(1 + 0.25 * 3, values.value(0, values.state(0, 1, 0), 0), 1e-12);
  }

  @Test
  void qLearningUpdatesWithTheBestAction() {
    TemporalDifferenceZoomPolicy policy =
        startPolicy("q-learning:epsilon=1,alpha=0.5,gamma=0.5,ties=narrowest");
    ActionValues values = forcedRound(policy);
    assertEquals(1 + 0.25 * 8, values.value(0, values.state(0, 1, 0), 0), 1e-12);
  }

  @Test
  void reportsValuesOfThePresentState() {
    for (String name : BOTH) {
      TemporalDifferenceZoomPolicy policy = startPolicy(name + ":epsilon=0,ties=narrowest");
      start();
      network.step(policy);
      policy.q().set(0, policy.q().state(0, 0, 2), 1, 7);
      double[] estimates = new double[2];
      double[] counts = new double[2];
      assertEquals("Q", policy.estimates(0, estimates, counts));
      assertArrayEquals(new double[] {0, 7}, estimates);
      assertArrayEquals(new double[] {Double.NaN, Double.NaN}, counts);
    }
  }

  @Test
  void sarsaAndQLearningLearnTheBestView() {
    for (String name : BOTH) {
      start();
      TemporalDifferenceZoomPolicy policy = startPolicy(name);
      int atBest = 0;
      for (int step = 0; step < 5_000; step++) {
        network.step(policy);
        atBest += network.view(0) == 0 ? 1 : 0;
      }
      assertTrue(atBest > 4_200, name + " at the best view in " + atBest + " steps");
    }
  }

  @Test
  void qLearningConvergesToKnownValues() {
    start();
    TemporalDifferenceZoomPolicy policy = startPolicy("q-learning:gamma=0.5,epsilon=0.5");
    for (int step = 0; step < 20_000; step++) {
      network.step(policy);
    }
    ActionValues values = policy.q();
    int wide = values.state(0, 1, 0);
    int narrow = values.state(0, 0, 2);
    assertEquals(2, values.value(0, wide, 0), 1e-3, "gains two, then stays");
    assertEquals(1, values.value(0, wide, 1), 1e-3, "waits one step to gain two");
    assertEquals(0, values.value(0, narrow, 0), 1e-3, "stays");
    assertEquals(-1, values.value(0, narrow, 1), 1e-3, "loses two, then gains them");
  }

  @Test
  void sarsaConvergesToValuesOfItsExploringPolicy() {
    start();
    TemporalDifferenceZoomPolicy policy = startPolicy("sarsa:gamma=0.5,epsilon=0.5,alpha=0.002");
    for (int step = 0; step < 200_000; step++) {
      network.step(policy);
    }
    ActionValues values = policy.q();
    int wide = values.state(0, 1, 0);
    int narrow = values.state(0, 0, 2);
    assertEquals(1.5, values.value(0, wide, 0), 0.05, "2 + (0 * 0.5 - 2 * 0.5) gamma");
    assertEquals(0.5, values.value(0, wide, 1), 0.05);
    assertEquals(-0.5, values.value(0, narrow, 0), 0.05);
    assertEquals(-1.5, values.value(0, narrow, 1), 0.05);
  }

  @Test
  void offlineCameraGetsNoRewardForMissedSteps() {
    network.see(0, 1, 1);
    TemporalDifferenceZoomPolicy policy = startPolicy("sarsa:epsilon=0,gamma=0,ties=narrowest");
    start();
    network.decide(policy);
    network.switchCamera(0, false);
    network.step(policy);
    network.switchCamera(0, true);
    network.step(policy);
    ActionValues values = policy.q();
    assertEquals(0, values.value(0, values.state(0, 1, 1), 0), "nothing lost by its own choice");
  }

  @Test
  void stateReadingsDistinguishStates() {
    assertStates("sarsa:state=level-count", 6);
    assertStates("sarsa:state=count", 3);
    assertStates("sarsa:state=none", 1);
  }

  @Test
  void everyActionStartsAtTheInitialValue() {
    ActionValues values = startPolicy("sarsa:q0=2.5").q();
    assertEquals(2.5, values.value(0, values.state(0, 1, 2), 1));
  }

  @Test
  void lambdaScalesTheReward() {
    TemporalDifferenceZoomPolicy policy =
        startPolicy("sarsa:lambda=3,epsilon=0,alpha=1,gamma=0,ties=narrowest");
    start();
    network.step(policy);
    network.decide(policy);
    assertEquals(6, policy.q().value(0, policy.q().state(0, 1, 0), 0));
  }

  @Test
  void rejectsTablesThatAreTooLarge() {
    ToyNetwork crowd = new ToyNetwork(2_000_000, 12);
    InputException error =
        assertThrows(InputException.class, () -> crowd.begin(registry.create("sarsa"), 1));
    assertTrue(error.getMessage().contains("state=none"), error.getMessage());
  }

  /** Moves from the wide view to the narrow one, and then explores. */
  private ActionValues forcedRound(TemporalDifferenceZoomPolicy policy) {
    ActionValues values = policy.q();
    int wide = values.state(0, 1, 0);
    int narrow = values.state(0, 0, 2);
    values.set(0, wide, 1, 1);
    values.set(0, narrow, 0, 8);
    values.set(0, narrow, 1, 3);
    start();
    network.step(policy);
    assertEquals(0, network.view(0), "explores away from the best, which is the wide view");
    network.decide(policy);
    assertEquals(1, network.view(0), "explores away from the best, which is the narrow view");
    return values;
  }

  private void assertStates(String spec, int states) {
    ActionValues values = startPolicy(spec).q();
    long distinct =
        java.util.stream.IntStream.range(0, 6)
            .map(i -> values.state(0, i / 3, i % 3))
            .distinct()
            .count();
    assertEquals(states, distinct);
  }

  private void start() {
    network.setView(0, 1);
    network.observe();
  }

  private TemporalDifferenceZoomPolicy startPolicy(String spec) {
    return (TemporalDifferenceZoomPolicy) network.begin(registry.create(spec), 1);
  }
}
