package org.hificamsim.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.Map;
import org.hificamsim.core.Reference;
import org.hificamsim.core.world.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** CamSim's recorded owners, ranges and confidences, step by step. */
class CamSimNetworkTraceTest {
  private static final String RUNS =
      """
      ICDSC2012-scenario_5__Active__c0__s0__t200 | ICDSC2012/scenario_5.xml \
      | -a active -c 0 -s 0 -t 200
      SASO-360-scenario12_corridor_fail__Passive__c0__s0__t300 \
      | SASO-360/scenario12_corridor_fail.xml | -a passive -c 0 -s 0 -t 300
      SASO-360-scenario6__BanditZoom__c0__s0__t500__bandit-SoftMax | SASO-360/scenario6.xml \
      | -a epics.ai.dynamicZoom.BanditSolverZoom -b epics.bandits.SoftMax -c 0 -s 0 -t 500
      SASO-scenario6__Active__c0__s0__t1000 | SASO/scenario6.xml | -a active -c 0 -s 0 -t 1000
      SASO-scenario6__Active__c0__s1__t500__move-DirectedBrownian | SASO/scenario6.xml \
      | -a active -c 0 -s 1 -t 500 -m epics.movement.DirectedBrownian
      SASO-scenario6__Passive__c1__s2__t500__move-Brownian | SASO/scenario6.xml \
      | -a passive -c 1 -s 2 -t 500 -m Brownian
      """;

  private record Key(int step, String camera, String target) {}

  @ParameterizedTest
  @CsvSource(delimiter = '|', textBlock = RUNS)
  void ownersAndRangesEqualTheRecordedOnes(String trace, String scenario, String options) {
    Map<Key, Double> ours = new HashMap<>();
    RecordedRun.of(scenario, options).run((world, network) -> addOwners(world, network, ours));
    assertEqualTo(trace + ".owners.csv", ours);
  }

  @ParameterizedTest
  @CsvSource(delimiter = '|', textBlock = RUNS)
  void confidencesEqualTheRecordedOnes(String trace, String scenario, String options) {
    Map<Key, Double> ours = new HashMap<>();
    RecordedRun.of(scenario, options).run((world, network) -> addConfidences(world, network, ours));
    assertEqualTo(trace + ".confidences.csv", ours);
  }

  private static void assertEqualTo(String trace, Map<Key, Double> ours) {
    Map<Key, Double> recorded = new HashMap<>();
    for (String[] row : Reference.rows("camsim/traces/" + trace)) {
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
            world.cameras().zoom(camera, world.cameras().level(camera)).radius());
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
