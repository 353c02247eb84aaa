package org.hificamsim.agents.temporal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.hificamsim.agents.CoveragePolicies;
import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.junit.jupiter.api.Test;

/** Tests learners whose moves take time, so that a decision lasts until the camera has arrived. */
class MovingLearnersTest {
  private final Registry<ZoomPolicy> registry = CoveragePolicies.register(new Registry<>("policy"));

  /** A camera with two views, whose move takes three steps; the narrow view detects two targets. */
  private final ToyNetwork network = new ToyNetwork(3, 2).see(0, 0, 0, 1).see(0, 1, 2).slow(2);

  @Test
  void rewardsAndDiscountsEveryStepOfAMove() {
    TemporalDifferenceZoomPolicy policy =
        startPolicy("sarsa:epsilon=0,alpha=1,gamma=0.5,ties=narrowest");
    network.observe();
    ActionValues values = policy.q();
    int wide = values.state(0, 1, 1);
    values.set(0, values.state(0, 0, 2), 0, 8);
    for (int step = 0; step < 3; step++) {
      network.step(policy);
      assertEquals(0, values.value(0, wide, 0), "not before it has arrived");
    }
    network.decide(policy);
    double lostFirst = -1;
    double foundLast = 0.25 * 2;
    assertEquals(lostFirst + foundLast + 0.125 * 8, values.value(0, wide, 0));
  }

  @Test
  void decisionsHoldUntilArrival() {
    for (String name :
        List.of("random", "epsilon-greedy", "softmax:temperature=9", "ucb1", "sarsa", "qb-sarsa")) {
      ZoomPolicy policy = network.begin(registry.create(name), 1);
      int moves = 0;
      for (int step = 0; step < 400; step++) {
        int before = network.view(0);
        boolean moving = network.seeing(0) < 0;
        network.step(policy);
        assertTrue(!moving || before == network.view(0), name + " in step " + step);
        moves += before == network.view(0) ? 0 : 1;
      }
      assertTrue(moves > 0, name + " moves");
    }
  }

  @Test
  void meanOfBanditIncludesStepsOfMoves() {
    ZoomPolicy policy =
        network.begin(registry.create("epsilon-greedy:epsilon=0,ties=narrowest"), 1);
    for (int step = 0; step < 4; step++) {
      network.step(policy);
    }
    double[] means = new double[2];
    double[] counts = new double[2];
    policy.estimates(0, means, counts);
    assertEquals(4, counts[0]);
    assertEquals((0 + 0 + 2 + 2) / 4.0, means[0]);
  }

  @Test
  void movingCameraSendsNoQuery() {
    ToyNetwork pair = new ToyNetwork(1, 2, 2).slow(2);
    ZoomPolicy policy = pair.begin(registry.create("qb-sarsa:epsilon=0,ties=narrowest"), 1);
    pair.step(policy);
    assertEquals(4, policy.messages());
    pair.step(policy);
    pair.step(policy);
    assertEquals(4, policy.messages());
    pair.step(policy);
    assertEquals(8, policy.messages());
  }

  private TemporalDifferenceZoomPolicy startPolicy(String spec) {
    return (TemporalDifferenceZoomPolicy) network.begin(registry.create(spec), 1);
  }
}
