package org.hificamsim.agents.optimal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.hificamsim.agents.toy.GeometricNetwork;
import org.hificamsim.agents.toy.ToyNetwork;
import org.junit.jupiter.api.Test;

class OptimalZoomPolicyTest {
  private static final GeometricNetwork.Kind NESTED =
      new GeometricNetwork.Kind(6, 4, 5, 1, true, true, 12, 16);

  @Test
  void findsTheOptimumWithRingsAndSectors() {
    compare(new GeometricNetwork.Kind(5, -4, 4, 3, false, true, 12, 16), 2_000);
  }

  @Test
  void findsTheOptimumWithRingsAllRound() {
    compare(new GeometricNetwork.Kind(6, 3, 5, 1, false, false, 10, 16), 1_500);
  }

  @Test
  void findsTheOptimumWithNestedSets() {
    compare(new GeometricNetwork.Kind(5, -4, 4, 3, true, true, 12, 16), 1_500);
  }

  @Test
  void findsTheOptimumWithManyTargets() {
    compare(new GeometricNetwork.Kind(5, 3, 70, 2, false, false, 4, 40), 200);
  }

  @Test
  void findsTheOptimumWithASingleView() {
    compare(new GeometricNetwork.Kind(4, 1, 2, 1, true, false, 10, 16), 50);
  }

  @Test
  void keepsNarrowestDominatingViewWithoutFurtherQueries() {
    GeometricNetwork network = GeometricNetwork.random(NESTED, 3);
    OptimalZoomPolicy policy = network.begin(new OptimalZoomPolicy(1_000_000), 1);
    network.decide(policy);
    int[] views = network.currentViews();
    long queries = network.globalQueries();
    for (int step = 0; step < 100; step++) {
      network.scatter();
      network.decide(policy);
      assertArrayEquals(views, network.currentViews());
    }
    assertEquals(queries, network.globalQueries());
    for (int camera = 0; camera < views.length; camera++) {
      for (int view = 0; view < network.views(camera); view++) {
        assertTrue(network.dominates(camera, views[camera], view));
        assertTrue(view >= views[camera] || !network.dominates(camera, view, views[camera]));
      }
    }
  }

  @Test
  void queriesAgainAfterChangesOfTheNetwork() {
    GeometricNetwork network = GeometricNetwork.random(NESTED, 3);
    OptimalZoomPolicy policy = network.begin(new OptimalZoomPolicy(1_000_000), 1);
    network.decide(policy);
    long queries = network.globalQueries();
    network.switchCamera(0, false);
    network.decide(policy);
    assertTrue(network.globalQueries() > queries);
  }

  @Test
  void keepsViewsWithoutTargets() {
    ToyNetwork network = new ToyNetwork(1, 3, 3).see(0, 0, 0).see(1, 1, 0);
    OptimalZoomPolicy policy = network.begin(new OptimalZoomPolicy(1_000_000), 1);
    network.showTarget(0, false);
    network.decide(policy);
    assertArrayEquals(new int[] {2, 2}, network.currentViews());
    network.showTarget(0, true);
    network.decide(policy);
    assertArrayEquals(new int[] {0, 1}, network.currentViews());
  }

  @Test
  void keepsViewsOfDominatedCamerasWithoutTargets() {
    GeometricNetwork network = GeometricNetwork.random(NESTED, 3);
    int[] views = network.currentViews();
    OptimalZoomPolicy policy = network.begin(new OptimalZoomPolicy(1_000_000), 1);
    for (int target = 0; target < network.targets(); target++) {
      network.showTarget(target, false);
    }
    network.decide(policy);
    assertArrayEquals(views, network.currentViews());
    network.showTarget(0, true);
    network.decide(policy);
    assertFalse(Arrays.equals(views, network.currentViews()));
  }

  @Test
  void prefersMostDetectionsThenNarrowestView() {
    ToyNetwork network = new ToyNetwork(2, 4).see(0, 0, 1).see(0, 1, 0, 1).see(0, 2, 0, 1);
    network.decide(network.begin(new OptimalZoomPolicy(1_000_000), 1));
    assertEquals(1, network.view(0));
  }

  @Test
  void doesNotChangeOfflineCameras() {
    ToyNetwork network = new ToyNetwork(1, 3, 3).see(0, 0, 0).see(1, 1, 0);
    network.switchCamera(0, false);
    network.decide(network.begin(new OptimalZoomPolicy(1_000_000), 1));
    assertArrayEquals(new int[] {2, 1}, network.currentViews());
  }

  private static void compare(GeometricNetwork.Kind kind, int worlds) {
    int positive = 0;
    for (int world = 0; world < worlds; world++) {
      GeometricNetwork network = GeometricNetwork.random(kind, world);
      OptimalZoomPolicy policy = network.begin(new OptimalZoomPolicy(1_000_000), 1);
      for (int step = 0; step < 3; step++) {
        network.decide(policy);
        network.observe();
        int found = network.kMin();
        int[] widest = Arrays.stream(views(network)).map(count -> count - 1).toArray();
        assertEquals(
            BestConfiguration.kMin(network, new int[widest.length], widest),
            found,
            "world " + world + " step " + step);
        positive += found > 0 ? 1 : 0;
        network.scatter();
        network.disturb();
      }
    }
    assertTrue(positive > worlds / 10, "only " + positive + " cases could cover all targets");
  }

  private static int[] views(ToyNetwork network) {
    int[] views = new int[network.cameras()];
    Arrays.setAll(views, network::views);
    return views;
  }

  @Test
  void reportsUnprovenStepsAndTheirGap() {
    GeometricNetwork.Kind rings = new GeometricNetwork.Kind(12, 4, 12, 1, false, false, 20, 15);
    GeometricNetwork network = GeometricNetwork.random(rings, 1);
    OptimalZoomPolicy limited = network.begin(new OptimalZoomPolicy(0), 1);
    OptimalZoomPolicy exact = network.begin(new OptimalZoomPolicy(1_000_000), 1);
    long lost = 0;
    for (int step = 0; step < 300; step++) {
      network.step(limited);
      int found = network.kMin();
      network.step(exact);
      lost += network.kMin() - found;
      network.scatter();
    }
    assertEquals(0, exact.unprovenSteps());
    assertEquals(0, exact.gap());
    assertTrue(limited.unprovenSteps() > 0, "no step in which the limit mattered");
    assertTrue(limited.gap() >= limited.unprovenSteps());
    assertTrue(lost <= limited.gap(), lost + " lost, the gap is " + limited.gap());
  }
}
