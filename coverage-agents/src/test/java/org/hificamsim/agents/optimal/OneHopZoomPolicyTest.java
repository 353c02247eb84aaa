package org.hificamsim.agents.optimal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.agents.CoveragePolicies;
import org.hificamsim.agents.optimal.OneHopZoomPolicy.Preference;
import org.hificamsim.agents.toy.GeometricNetwork;
import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.registry.Registry;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class OneHopZoomPolicyTest {
  @Test
  void reachesTheBestReachableScore() {
    for (Preference preference : Preference.values()) {
      for (int world = 0; world < 400; world++) {
        compare(
            GeometricNetwork.random(
                new GeometricNetwork.Kind(6, -5, 3, 2, false, true, 10, 16), world),
            preference);
      }
    }
  }

  @Test
  void prefersWiderViewsWithoutGain() {
    ToyNetwork network = new ToyNetwork(1, 4, 4);
    network.setView(0, 1);
    network.decide(network.begin(new OneHopZoomPolicy(Options.none("one-hop")), 1));
    assertArrayEquals(new int[] {2, 3}, network.currentViews());
  }

  /** Users' commands contain these names. */
  @ParameterizedTest
  @ValueSource(
      strings = {"widest", "narrowest", "most-targets-then-widest", "most-targets-then-narrowest"})
  void acceptsNamesOfTies(String ties) {
    assertEquals(
        "one-hop",
        CoveragePolicies.register(new Registry<>("policy")).create("one-hop:ties=" + ties).name());
  }

  @Test
  void mostTargetsKeepsDetectionsWithoutGain() {
    ToyNetwork network = new ToyNetwork(2, 4).see(0, 1, 0).see(0, 0, 0);
    network.setView(0, 1);
    Preference preference = Preference.MOST_TARGETS_THEN_WIDEST;
    network.decide(network.begin(oneHop(preference), 1));
    assertEquals(1, network.view(0));
  }

  @Test
  void keepsViewsWithoutTargets() {
    ToyNetwork network = new ToyNetwork(1, 4);
    network.setView(0, 1);
    network.showTarget(0, false);
    network.decide(network.begin(new OneHopZoomPolicy(Options.none("one-hop")), 1));
    assertEquals(1, network.view(0));
  }

  private static OneHopZoomPolicy oneHop(Preference preference) {
    return new OneHopZoomPolicy(Options.parse("one-hop", "ties=" + Spelling.of(preference)));
  }

  private static void compare(GeometricNetwork network, Preference preference) {
    OneHopZoomPolicy policy = network.begin(oneHop(preference), 1);
    for (int step = 0; step < 4; step++) {
      int[] before = network.currentViews();
      int[] lowest = new int[before.length];
      int[] highest = new int[before.length];
      for (int camera = 0; camera < before.length; camera++) {
        lowest[camera] = Math.max(0, before[camera] - 1);
        highest[camera] = Math.min(network.views(camera) - 1, before[camera] + 1);
      }
      network.decide(policy);
      network.observe();
      int found = network.kMin();
      for (int camera = 0; camera < before.length; camera++) {
        assertTrue(Math.abs(network.view(camera) - before[camera]) <= 1);
      }
      assertEquals(BestConfiguration.kMin(network, lowest, highest), found);
      network.scatter();
      network.disturb();
    }
  }
}
