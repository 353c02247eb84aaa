package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.TreeSet;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.camsim.CamSimRangeDetection;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that the pairs of cameras and seen targets equal the answers for each pair. */
class SeenTargetsTest {
  private static final int CAMERAS = 6;
  private static final int TARGETS = 40;

  private record Seen(double distance, double bearing) {}

  @ParameterizedTest
  @ValueSource(doubles = {0.5, 3, 100})
  void findsSamePairsAsQueriesOfSinglePairs(double side) {
    World world = world();
    Visibility visibility = Visibility.of(new Detection(new CamSimRangeDetection(), 0.01));
    TestNetwork network = new TestNetwork(world, visibility, side);
    network.beginStep(0);
    network.locate();
    SeenPairs pairs = new SeenPairs();
    network.findSeen(pairs);
    int total = 0;
    for (int camera = 0; camera < CAMERAS; camera++) {
      Map<Integer, Seen> seen = byPair(network, camera);
      assertFound(seen, network, camera, pairs);
      total += seen.size();
    }
    assertEquals(total, pairs.count());
    assertTrue(total > 20 && total < CAMERAS * TARGETS / 2, total + " seen");
  }

  /** Checks the targets of a camera and their positions in front of it. */
  private static void assertFound(
      Map<Integer, Seen> seen, TestNetwork network, int camera, SeenPairs pairs) {
    Set<Integer> found = new TreeSet<>();
    for (int pair = 0; pair < pairs.count(); pair++) {
      if (pairs.camera(pair) == camera) {
        int target = pairs.target(pair);
        found.add(target);
        Seen expected = seen.get(target);
        double confidence = network.seenConfidence(camera, target, expected.distance);
        assertEquals(network.confidence(camera, target), confidence, 1e-8);
        assertEquals(expected.distance * Math.cos(expected.bearing), pairs.ahead(pair), 1e-12);
        assertEquals(expected.distance * Math.sin(expected.bearing), pairs.right(pair), 1e-12);
        assertEquals(expected.distance, pairs.distance(pair), 1e-12);
      }
    }
    assertEquals(seen.keySet(), found);
  }

  private static Map<Integer, Seen> byPair(NetworkView network, int camera) {
    Map<Integer, Seen> seen = new TreeMap<>();
    for (int target = 0; target < TARGETS; target++) {
      if (network.sees(camera, target)) {
        seen.put(
            target, new Seen(network.distance(camera, target), network.bearing(camera, target)));
      }
    }
    return seen;
  }

  private static World world() {
    SplittableRandom random = new SplittableRandom(3);
    TestScenario scenario = new TestScenario().zooms(3, 6);
    for (int camera = 0; camera < CAMERAS; camera++) {
      scenario.camera(
          TestScenario.camera(
              "c" + camera,
              random.nextDouble(-10, 10),
              random.nextDouble(-10, 10),
              random.nextDouble(360),
              camera == 0 ? 360 : 120,
              6));
    }
    for (int target = 0; target < TARGETS; target++) {
      scenario.target(random.nextDouble(-10, 10), random.nextDouble(-10, 10));
    }
    return scenario.world();
  }
}
