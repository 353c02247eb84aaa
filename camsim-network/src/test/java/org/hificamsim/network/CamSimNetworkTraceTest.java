package org.hificamsim.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.CamSimTrace;
import org.hificamsim.core.world.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Compares owners, ranges and confidences with those recorded from CamSim, step by step. */
class CamSimNetworkTraceTest {
  private record Key(int step, String camera, String target) {}

  @ParameterizedTest
  @MethodSource("org.hificamsim.core.CamSimTrace#all")
  void ownersAndRangesEqualRecording(CamSimTrace trace) {
    Map<Key, Double> ours = new HashMap<>();
    run(trace, (world, network) -> addOwners(world, network, ours));
    assertEqualTo(trace.rows("owners"), ours);
  }

  @ParameterizedTest
  @MethodSource("org.hificamsim.core.CamSimTrace#all")
  void confidencesEqualRecording(CamSimTrace trace) {
    Map<Key, Double> ours = new HashMap<>();
    run(trace, (world, network) -> addConfidences(world, network, ours));
    assertEqualTo(trace.rows("confidences"), ours);
  }

  private static void run(CamSimTrace trace, RecordedRun.Watcher watcher) {
    new RecordedRun(trace.command()).run(watcher);
  }

  private static void assertEqualTo(List<String[]> rows, Map<Key, Double> ours) {
    Map<Key, Double> recorded = new HashMap<>();
    for (String[] row : rows) {
      recorded.put(new Key(Integer.parseInt(row[0]), row[1], row[2]), Double.parseDouble(row[3]));
    }
    assertEquals(recorded.keySet(), ours.keySet());
    recorded.forEach((key, value) -> assertEquals(value, ours.get(key), 1e-9, key::toString));
    assertTrue(recorded.size() > 300, recorded.size() + " rows compared");
  }

  private static void addOwners(World world, Network network, Map<Key, Double> into) {
    for (int camera = 0; camera < world.cameras().count(); camera++) {
      for (int target : network.owned(camera)) {
        into.put(
            key(world, network, camera, target),
            world.cameras().zoom(camera, world.cameras().view(camera)).radius());
      }
    }
  }

  private static void addConfidences(World world, Network network, Map<Key, Double> into) {
    for (int camera = 0; camera < world.cameras().count(); camera++) {
      for (int target = 0; target < world.targets().count(); target++) {
        if (world.cameras().online(camera) && network.sightings().sees(camera, target)) {
          into.put(
              key(world, network, camera, target), network.sightings().confidence(camera, target));
        }
      }
    }
  }

  private static Key key(World world, Network network, int camera, int target) {
    return new Key(
        (int) network.figures().step(), world.cameras().name(camera), world.targets().name(target));
  }
}
