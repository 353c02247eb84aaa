package org.hificamsim.runs.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.runs.RunPlan;
import org.junit.jupiter.api.Test;

class ReferencePoliciesTest {
  private static final Path SHIPPED =
      Path.of(System.getProperty("hificamsim.root", "."), "scenarios", "ring-random.xml");

  @Test
  void optimumAndBestFixedFollowThePlans() {
    assertEquals(
        List.of("sarsa", "random", "optimal", "best-fixed"),
        policies(ReferencePolicies.OPTIMUM_AND_BEST_FIXED, 100, "sarsa", "random"));
    assertEquals(
        List.of("sarsa", "random", "optimal"),
        policies(ReferencePolicies.OPTIMUM, 100, "sarsa", "random"));
  }

  @Test
  void addsNoYardstickThatIsAmongPlans() {
    assertEquals(
        List.of("best-fixed", "optimal"),
        policies(ReferencePolicies.OPTIMUM_AND_BEST_FIXED, 100, "best-fixed", "optimal"));
  }

  @Test
  void omitsBestFixedThatNeedsTooMuchMemory() {
    assertEquals(
        List.of("sarsa", "optimal"),
        policies(ReferencePolicies.OPTIMUM_AND_BEST_FIXED, 1_000_000_000, "sarsa"));
    assertEquals(
        List.of("best-fixed", "optimal"),
        policies(ReferencePolicies.OPTIMUM_AND_BEST_FIXED, 1_000_000_000, "best-fixed"));
  }

  private static List<String> policies(ReferencePolicies references, int steps, String... asked) {
    Catalogue catalogue = Catalogue.load();
    Scenario scenario = ScenarioReader.read(SHIPPED, name -> true, warning -> {});
    DetectionModel model = catalogue.detection("geometric");
    Detection detection = new Detection(model.name(), model, model.defaultThreshold());
    List<RunPlan> plans =
        List.of(asked).stream()
            .map(policy -> new RunPlan(scenario, detection, policy, steps, 0, 2))
            .toList();
    return references.with(plans).stream().map(RunPlan::policy).toList();
  }
}
