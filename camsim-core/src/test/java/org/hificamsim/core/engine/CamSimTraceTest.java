package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.Reference;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.movement.Movements;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** CamSim's recorded positions and confidences, step by step. */
class CamSimTraceTest {
  private record Key(int step, String camera, String target) {}

  private record Position(double x, double y) {}

  @ParameterizedTest
  @CsvSource({
    "ICDSC2012-scenario_5__Active__c0__s0__t200, ICDSC2012/scenario_5, 0, 200, , 0",
    "SASO-360-scenario12_corridor_fail__Passive__c0__s0__t300,"
        + " SASO-360/scenario12_corridor_fail, 0, 300, , 0",
    "SASO-360-scenario6__BanditZoom__c0__s0__t500__bandit-SoftMax, SASO-360/scenario6, 0, 500, , 0",
    "SASO-scenario6__Active__c0__s0__t1000, SASO/scenario6, 0, 1000, , 0",
    "SASO-scenario6__Active__c0__s1__t500__move-DirectedBrownian,"
        + " SASO/scenario6, 1, 500, DirectedBrownian, 3e-13",
    "SASO-scenario6__Passive__c1__s2__t500__move-Brownian,"
        + " SASO/scenario6, 2, 500, Brownian, 3e-13",
  })
  void positionsEqualTheRecordedOnes(
      String trace, String file, long seed, int steps, String movement, double tolerance) {
    Map<Key, Position> recorded = new HashMap<>();
    for (String[] row : Reference.rows("camsim/traces/" + trace + ".positions.csv")) {
      recorded.put(
          new Key(Integer.parseInt(row[0]), "", row[1]),
          new Position(Double.parseDouble(row[2]), Double.parseDouble(row[3])));
    }
    Map<Key, Position> ours = new HashMap<>();
    run(file, seed, steps, movement, (network, coverage) -> addPositions(network, ours));
    assertEquals(recorded.keySet(), ours.keySet());
    recorded.forEach(
        (key, position) -> {
          assertEquals(position.x(), ours.get(key).x(), tolerance, () -> key + " x");
          assertEquals(position.y(), ours.get(key).y(), tolerance, () -> key + " y");
        });
    assertTrue(recorded.size() >= steps, recorded.size() + " positions compared");
  }

  @ParameterizedTest
  @CsvSource({
    "ICDSC2012-scenario_5__Active__c0__s0__t200, ICDSC2012/scenario_5, 0, 200,",
    "SASO-360-scenario12_corridor_fail__Passive__c0__s0__t300,"
        + " SASO-360/scenario12_corridor_fail, 0, 300,",
    "SASO-scenario6__Active__c0__s0__t1000, SASO/scenario6, 0, 1000,",
    "SASO-scenario6__Active__c0__s1__t500__move-DirectedBrownian,"
        + " SASO/scenario6, 1, 500, DirectedBrownian",
    "SASO-scenario6__Passive__c1__s2__t500__move-Brownian, SASO/scenario6, 2, 500, Brownian",
  })
  void confidencesOfVisiblePairsEqualTheRecordedOnes(
      String trace, String file, long seed, int steps, String movement) {
    Map<Key, Double> recorded = recordedConfidences(trace);
    Map<Key, Double> ours = new HashMap<>();
    run(file, seed, steps, movement, (network, coverage) -> addConfidences(network, ours));
    assertEquals(recorded.keySet(), ours.keySet());
    recorded.forEach((key, value) -> assertEquals(value, ours.get(key), 1e-9, key::toString));
    assertTrue(recorded.size() > 300, recorded.size() + " confidences compared");
  }

  /** CamSim's bandit zooms there: only the first step's ranges are those of the file. */
  @org.junit.jupiter.api.Test
  void confidencesOfTheZoomingRunEqualTheRecordedOnesBeforeTheFirstZoom() {
    Map<Key, Double> recorded =
        recordedConfidences("SASO-360-scenario6__BanditZoom__c0__s0__t500__bandit-SoftMax");
    recorded.keySet().removeIf(key -> key.step() > 10);
    Map<Key, Double> ours = new HashMap<>();
    run("SASO-360/scenario6", 0, 11, null, (network, coverage) -> addConfidences(network, ours));
    assertEquals(recorded.keySet(), ours.keySet());
    recorded.forEach((key, value) -> assertEquals(value, ours.get(key), 1e-9, key::toString));
  }

  private static Map<Key, Double> recordedConfidences(String trace) {
    Map<Key, Double> recorded = new HashMap<>();
    for (String[] row : Reference.rows("camsim/traces/" + trace + ".confidences.csv")) {
      recorded.put(new Key(Integer.parseInt(row[0]), row[1], row[2]), Double.parseDouble(row[3]));
    }
    return recorded;
  }

  private static void addPositions(NetworkView network, Map<Key, Position> into) {
    for (int target = 0; target < network.targets(); target++) {
      if (network.present(target)) {
        into.put(
            new Key((int) network.step(), "", network.targetName(target)),
            new Position(network.oracle().targetX(target), network.oracle().targetY(target)));
      }
    }
  }

  private static void addConfidences(NetworkView network, Map<Key, Double> into) {
    for (int camera = 0; camera < network.cameras(); camera++) {
      for (int target = 0; target < network.targets(); target++) {
        if (network.online(camera)
            && network.oracle().detects(camera, network.level(camera), target)) {
          into.put(
              new Key((int) network.step(), network.cameraName(camera), network.targetName(target)),
              network.confidence(camera, target));
        }
      }
    }
  }

  private static void run(
      String file, long seed, int steps, String movement, StepListener listener) {
    Scenario scenario =
        ScenarioReader.read(
            Reference.file("camsim/scenarios/" + file + ".xml"),
            name -> true,
            new ArrayList<>()::add);
    if (movement != null) {
      scenario = scenario.withMovement(movement);
    }
    new Simulation(
            new World(scenario, Movements.registry(), seed),
            Detection.of(new CamSimVisibilityDetection()),
            new WidestPolicy(),
            seed,
            List.of(listener))
        .run(steps);
  }
}
