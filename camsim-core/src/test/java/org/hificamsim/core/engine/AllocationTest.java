package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.hificamsim.core.AllocatedBytes;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.detection.camsim.CamSimRangeDetection;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that 20,000 steps allocate no memory after a warm-up. */
class AllocationTest {
  private static final int STEPS = 20_000;

  @ParameterizedTest
  @CsvSource({
    "Straight, distance",
    "Straight, bearing",
    "Scripted, distance",
    "Scripted, bearing",
    "Waypoints, distance",
    "Waypoints, bearing",
    "Brownian, distance",
    "DirectedBrownian, distance",
    "Straight, chance",
  })
  void stepAllocatesNothing(String movement, String kind) {
    DetectionModel model =
        kind.equals("bearing") ? new CamSimVisibilityDetection() : new CamSimRangeDetection();
    Detection detection =
        kind.equals("chance")
            ? Detection.by(DetectionRule.parse("probability:memory=3"), "drawn", model)
            : Detection.of(model);
    RunCoverage coverage = new RunCoverage();
    Simulation simulation =
        new Simulation(
            scenario(movement).world(), detection, new WidestPolicy(), 0, List.of(coverage));
    simulation.run(STEPS);
    int[] rounds = {0};
    Runnable round = () -> simulation.run(STEPS);
    long bytes =
        AllocatedBytes.fewest(
            () -> {
              rounds[0]++;
              return AllocatedBytes.by(round);
            });
    assertEquals(0, bytes, "bytes in " + STEPS + " steps");
    assertEquals((1L + rounds[0]) * STEPS, coverage.steps());
  }

  private static TestScenario scenario(String movement) {
    TestScenario scenario =
        needsCamSimDialect(movement) ? new TestScenario() : new TestScenario().zooms(2, 4, 6, 8);
    for (int i = 0; i < 4; i++) {
      scenario.camera(TestScenario.camera("c" + i, 2 * i - 4, i, 90 * i, i == 0 ? 360 : 120, 8));
      scenario.target(target(i, movement));
    }
    return scenario;
  }

  /**
   * Whether the scenario needs CamSim's dialect: with a zoom list, Waypoints would mean Scripted.
   */
  private static boolean needsCamSimDialect(String movement) {
    return movement.equals("Waypoints");
  }

  private static TargetSpec target(int i, String movement) {
    return TestScenario.walker(i, movement, 0.4, i, 0, 5, 5, -5, i)
        .with(TargetSpec.HEADING, 70 * i)
        .with(TargetSpec.STD, 0.1);
  }
}
