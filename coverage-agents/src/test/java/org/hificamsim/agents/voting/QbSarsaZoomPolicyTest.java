package org.hificamsim.agents.voting;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.agents.CoveragePolicies;
import org.hificamsim.agents.temporal.ActionValues;
import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.junit.jupiter.api.Test;

class QbSarsaZoomPolicyTest {
  private final Registry<ZoomPolicy> registry = CoveragePolicies.register(new Registry<>("policy"));

  @Test
  void neighboursOutvoteTheOwnView() {
    ToyNetwork network = new ToyNetwork(1, 3, 3, 3);
    QbSarsaZoomPolicy policy = start(network, "qb-sarsa:k=2,epsilon=0");
    prefer(policy, 0, 2, 0);
    prefer(policy, 1, 2, 1);
    prefer(policy, 2, 2, 1);
    network.decide(policy);
    assertArrayEquals(new int[] {1, 1, 1}, network.currentViews());
  }

  @Test
  void ownVoteDecidesADraw() {
    ToyNetwork network = new ToyNetwork(1, 3, 3);
    QbSarsaZoomPolicy policy = start(network, "qb-sarsa:epsilon=0");
    prefer(policy, 0, 2, 0);
    prefer(policy, 1, 2, 1);
    network.decide(policy);
    assertArrayEquals(new int[] {0, 1}, network.currentViews());
  }

  @Test
  void neighboursDecideWithoutTheOwnVote() {
    ToyNetwork network = new ToyNetwork(1, 3, 3);
    QbSarsaZoomPolicy policy = start(network, "qb-sarsa:epsilon=0,own-vote=no");
    prefer(policy, 0, 2, 0);
    prefer(policy, 1, 2, 1);
    network.decide(policy);
    assertArrayEquals(new int[] {1, 0}, network.currentViews());
  }

  @Test
  void neighboursAnswerForTheStateOfTheQuery() {
    ToyNetwork network = new ToyNetwork(1, 3, 3).see(0, 2, 0);
    network.observe();
    QbSarsaZoomPolicy policy = start(network, "qb-sarsa:epsilon=0,own-vote=no");
    policy.q().set(1, policy.q().state(1, 2, 1), 0, 1);
    policy.q().set(1, policy.q().state(1, 2, 0), 1, 1);
    network.decide(policy);
    assertEquals(0, network.view(0), "asked for a count of 1 although it detects none itself");
  }

  @Test
  void translatesLevelsByRelativePosition() {
    ToyNetwork network = new ToyNetwork(1, 3, 2);
    QbSarsaZoomPolicy policy = start(network, "qb-sarsa:epsilon=0,own-vote=no");
    prefer(policy, 1, 1, 0);
    network.decide(policy);
    assertEquals(0, network.view(0), "the query is for the widest view, the answer the narrowest");
    prefer(policy, 1, 0, 1);
    network.decide(policy);
    assertEquals(2, network.view(0), "the query is for the narrowest view, the answer the widest");
  }

  @Test
  void sendsNoQueryToOfflineNeighbours() {
    ToyNetwork network = new ToyNetwork(1, 3, 3, 3);
    QbSarsaZoomPolicy policy = start(network, "qb-sarsa:k=1,epsilon=0,own-vote=no");
    prefer(policy, 1, 2, 1);
    prefer(policy, 2, 2, 0);
    network.switchCamera(1, false);
    network.decide(policy);
    assertEquals(0, network.view(0));
    assertEquals(4, policy.messages());
  }

  @Test
  void countsAQueryAndAnAnswerForEachNeighbour() {
    ToyNetwork network = new ToyNetwork(1, 3, 3, 3, 3, 3, 3);
    QbSarsaZoomPolicy policy = start(network, "qb-sarsa:k=4");
    for (int step = 0; step < 10; step++) {
      network.step(policy);
    }
    assertEquals(10 * 6 * 2 * 4, policy.messages());
  }

  @Test
  void equalsSarsaWithoutNeighbours() {
    ToyNetwork alone = learned("qb-sarsa:k=0");
    ToyNetwork sarsa = learned("sarsa");
    assertArrayEquals(sarsa.currentViews(), alone.currentViews());
  }

  @Test
  void learnsTheBestView() {
    ToyNetwork network = world();
    ZoomPolicy policy = start(network, "qb-sarsa");
    int atBest = 0;
    for (int step = 0; step < 5_000; step++) {
      network.step(policy);
      atBest += network.view(2) == 1 ? 1 : 0;
    }
    assertTrue(atBest > 3_800, "at the best view in " + atBest + " steps");
  }

  private ToyNetwork learned(String spec) {
    ToyNetwork network = world();
    ZoomPolicy policy = network.begin(registry.create(spec), 5);
    for (int step = 0; step < 777; step++) {
      network.step(policy);
    }
    return network;
  }

  /** Returns a network of five cameras whose middle view of three detects most targets. */
  private static ToyNetwork world() {
    ToyNetwork network = new ToyNetwork(3, 3, 3, 3, 3, 3);
    for (int camera = 0; camera < 5; camera++) {
      network.see(camera, 1, 0, 1, 2).see(camera, 2, 0);
    }
    return network;
  }

  /** Makes an action the camera's best one in a view with nothing detected. */
  private static void prefer(QbSarsaZoomPolicy policy, int camera, int view, int action) {
    ActionValues values = policy.q();
    values.set(camera, values.state(camera, view, 0), action, 1);
  }

  private QbSarsaZoomPolicy start(ToyNetwork network, String spec) {
    return (QbSarsaZoomPolicy) network.begin(registry.create(spec), 1);
  }
}
