package org.hificamsim.runs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.AllocatedBytes;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.engine.RunCoverage;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.policy.HindsightZoomPolicy;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.generate.RandomField;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests that no step of any policy allocates memory after a warm-up, under any detection. */
class AllocationTest {
  private static final Catalogue CATALOGUE = Catalogue.load();

  static Stream<Arguments> steps() {
    return CATALOGUE.policies().names().stream()
        .filter(name -> !(CATALOGUE.policies().create(name) instanceof HindsightZoomPolicy))
        .flatMap(
            policy ->
                Stream.of("hifi:orb-lin", "camsim-visibility")
                    .map(detection -> Arguments.of(policy, detection)));
  }

  @ParameterizedTest
  @MethodSource("steps")
  void stepAllocatesNothing(String policy, String detection) {
    assertAllocatesNothing(policy, detection, RandomField.ofCameras(14, 5).scenario(), 6_000);
  }

  static Stream<String> policies() {
    return steps()
        .map(arguments -> (String) arguments.get()[0])
        .distinct()
        .filter(name -> !needsKMin(name));
  }

  private static boolean needsKMin(String policy) {
    return policy.equals("optimal-expected");
  }

  /**
   * The hall has lenses, pillars, people who hide each other, and cameras whose moves take time. A
   * line of sight that grazes something to within rounding is decided by numbers of any length,
   * which take memory; that is rare: less than 10 bytes a step on average.
   */
  @ParameterizedTest
  @MethodSource("policies")
  void stepInTheHallAllocatesOnlyForTies(String policy) {
    Path hall = Path.of(System.getProperty("hificamsim.root"), "scenarios", "hall.xml");
    Scenario scenario =
        ScenarioReader.read(hall, CATALOGUE.movements().names()::contains, warning -> {});
    long bytes = bytes(policy, "dori-2014:level=recognise", scenario, 1_000);
    assertTrue(bytes < 10 * 1_000, "bytes in 1,000 steps: " + bytes);
  }

  @Test
  void stepOfBigNetworkAllocatesNothing() {
    Scenario big = RandomField.ofCameras(200, 5).scenario();
    assertAllocatesNothing("epsilon-greedy", "hifi:orb-lin", big, 500);
    assertAllocatesNothing("sarsa", "camsim-visibility", big, 500);
    Scenario bigger = new RandomField(600, 100, RandomField.CLUSTER_AREA, 5).scenario();
    assertAllocatesNothing("qb-sarsa", "hifi:orb-lin", bigger, 500);
  }

  private static void assertAllocatesNothing(
      String policy, String detection, Scenario scenario, int steps) {
    assertEquals(0, bytes(policy, detection, scenario, steps), "in " + steps + " steps");
  }

  private static long bytes(String policyName, String detection, Scenario scenario, int steps) {
    DetectionModel model = CATALOGUE.detection(detection);
    ZoomPolicy policy = CATALOGUE.policies().create(policyName);
    World world = new World(scenario, CATALOGUE.movements(), 0);
    RunCoverage coverage = new RunCoverage();
    Simulation simulation =
        new Simulation(world, Detection.of(model), policy, 0, List.of(coverage));
    simulation.run(steps);
    long bytes = AllocatedBytes.fewest(() -> AllocatedBytes.by(() -> simulation.run(steps)));
    assertTrue(coverage.detections() > 0);
    return bytes;
  }
}
