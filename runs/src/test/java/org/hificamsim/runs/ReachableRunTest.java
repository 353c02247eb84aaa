package org.hificamsim.runs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.hificamsim.agents.optimal.ReachableZoomPolicy;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ReachableRunTest {
  private static final Path SHIPPED =
      Path.of(System.getProperty("hificamsim.root", "."), "scenarios");
  private static final Catalogue CATALOGUE = Catalogue.load();
  private static final long SEED = 700;
  private static final double ROUNDING = 1e-6;

  private final RunExecutor executor = new RunExecutor(CATALOGUE);

  private static RunPlan plan(String site, String policy, int steps) {
    Scenario scenario =
        ScenarioReader.read(
            SHIPPED.resolve(site + ".xml"), CATALOGUE.movements()::knows, warning -> {});
    DetectionModel model = CATALOGUE.detection("oodpcvs-2025:level=discern");
    Detection detection = new Detection(model.name(), model, model.defaultThreshold());
    return new RunPlan(scenario, detection, policy, steps, SEED, 1);
  }

  private RunResult run(RunPlan plan) {
    return executor.repeat(plan, 0, List.of());
  }

  private static ReachableZoomPolicy reachable() {
    return new Registry<ReachableZoomPolicy>("policy")
        .register("reachable", "", ReachableZoomPolicy::new)
        .create("reachable:iterations=2");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "campus",
        "junction",
        "corridor",
        "car-park",
        "hall",
        "warehouse",
        "border",
        "museum",
        "street",
        "passage"
      })
  void runReachesScoreOfPlan(String site) {
    RunPlan plan = plan(site, "reachable", 40);
    ReachableZoomPolicy policy = reachable();
    RunResult result = executor.repeat(plan, 0, policy, List.of());
    assertEquals(policy.planScore(), result.score());
    assertTrue(result.value(Metric.REACHABLE_BOUND) >= result.score());
  }

  @ParameterizedTest
  @ValueSource(strings = {"campus", "car-park", "street", "passage"})
  void boundIsTighterThanOptimumWithoutMovingTime(String site) {
    RunPlan plan = plan(site, "reachable:iterations=100", 60);
    RunResult reached = run(plan);
    double withoutMovingTime = run(plan(site, "optimal", 60)).score();
    double gap = reached.value(Metric.REACHABLE_BOUND) - reached.score();
    assertTrue(gap <= 0.9 * (withoutMovingTime - reached.score()), gap + " to " + reached.score());
  }

  @ParameterizedTest
  @ValueSource(strings = {"cooperative", "tracker", "patrol", "independent-greedy", "one-hop"})
  void boundsPoliciesWhoseMovesTakeTime(String policy) {
    for (String site : List.of("campus", "corridor", "border")) {
      double bound = run(plan(site, "reachable:iterations=20", 40)).value(Metric.REACHABLE_BOUND);
      assertTrue(run(plan(site, policy, 40)).score() <= bound + ROUNDING, site);
    }
  }

  @Test
  void equalsOptimumIfMovesTakeNoTime() {
    RunResult optimal = run(plan("ring-random", "optimal", 60));
    RunResult reachable = run(plan("ring-random", "reachable", 60));
    assertEquals(optimal.score(), reachable.score());
    assertEquals(optimal.score(), reachable.value(Metric.REACHABLE_BOUND));
  }
}
