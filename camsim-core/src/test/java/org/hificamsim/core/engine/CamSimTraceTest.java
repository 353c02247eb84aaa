package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.CamSimTrace;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.movement.Movements;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Compares positions and confidences with CamSim's records, step by step. */
class CamSimTraceTest {
  private record Key(int step, String camera, String target) {}

  private record Position(double x, double y) {}

  @ParameterizedTest
  @MethodSource("org.hificamsim.core.CamSimTrace#all")
  void positionsEqualRecordedOnes(CamSimTrace trace) {
    double tolerance = trace.command().option("-m").isPresent() ? 3e-13 : 0;
    Map<Key, Position> recorded = new HashMap<>();
    for (String[] row : trace.rows("positions")) {
      recorded.put(
          new Key(Integer.parseInt(row[0]), "", row[1]),
          new Position(Double.parseDouble(row[2]), Double.parseDouble(row[3])));
    }
    Map<Key, Position> ours = new HashMap<>();
    run(trace, trace.command().steps(), (network, coverage) -> addPositions(network, ours));
    assertEquals(recorded.keySet(), ours.keySet());
    recorded.forEach(
        (key, position) -> {
          assertEquals(position.x(), ours.get(key).x(), tolerance, () -> key + " x");
          assertEquals(position.y(), ours.get(key).y(), tolerance, () -> key + " y");
        });
    assertTrue(recorded.size() >= trace.command().steps(), recorded.size() + " positions compared");
  }

  /** If CamSim's bandit zooms, only the first steps have the ranges of the file. */
  @ParameterizedTest
  @MethodSource("org.hificamsim.core.CamSimTrace#all")
  void confidencesEqualRecordedOnesBeforeAnyZoom(CamSimTrace trace) {
    boolean zooming = trace.command().option("-b").isPresent();
    int steps = zooming ? 11 : trace.command().steps();
    Map<Key, Double> recorded = new HashMap<>();
    for (String[] row : trace.rows("confidences")) {
      recorded.put(new Key(Integer.parseInt(row[0]), row[1], row[2]), Double.parseDouble(row[3]));
    }
    recorded.keySet().removeIf(key -> key.step() >= steps);
    Map<Key, Double> ours = new HashMap<>();
    run(trace, steps, (network, coverage) -> addConfidences(network, ours));
    assertEquals(recorded.keySet(), ours.keySet());
    recorded.forEach((key, value) -> assertEquals(value, ours.get(key), 1e-9, key::toString));
    assertTrue(zooming || recorded.size() > 300, recorded.size() + " confidences compared");
  }

  private static void addPositions(OracleView network, Map<Key, Position> into) {
    for (int target = 0; target < network.targets(); target++) {
      if (network.present(target)) {
        into.put(
            new Key((int) network.step(), "", network.targetName(target)),
            new Position(network.targetX(target), network.targetY(target)));
      }
    }
  }

  private static void addConfidences(OracleView network, Map<Key, Double> into) {
    for (int camera = 0; camera < network.cameras(); camera++) {
      for (int target = 0; target < network.targets(); target++) {
        if (network.online(camera) && network.detects(camera, network.view(camera), target)) {
          into.put(
              new Key((int) network.step(), network.cameraName(camera), network.targetName(target)),
              network.confidence(camera, target));
        }
      }
    }
  }

  private static void run(CamSimTrace trace, int steps, StepListener listener) {
    long seed = trace.command().seed();
    new Simulation(
            new World(trace.command().read(), Movements.registry(), seed),
            Detection.of(new CamSimVisibilityDetection()),
            new WidestPolicy(),
            seed,
            List.of(listener))
        .run(steps);
  }
}
