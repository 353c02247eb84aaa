package org.hificamsim.runs.hints;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.ReferencePolicies;
import org.hificamsim.runs.generate.RandomField;
import org.hificamsim.runs.generate.RandomSite;
import org.junit.jupiter.api.Test;

class OptimumTimeTest {
  private static final Catalogue CATALOGUE = Catalogue.load();

  @Test
  void forecastsHoursForABillionSteps() {
    OptimumTime.Forecast forecast =
        forecast(ReferencePolicies.OPTIMUM, Scenario.MAX_STEPS).orElseThrow();
    assertEquals("random-6", forecast.slowest());
    assertTrue(forecast.secondsPerStep() > 0);
    assertTrue(forecast.total().compareTo(Duration.ofHours(1)) > 0);
  }

  @Test
  void forecastsSecondsForTenSteps() {
    OptimumTime.Forecast forecast = forecast(ReferencePolicies.OPTIMUM, 10).orElseThrow();
    assertTrue(forecast.total().compareTo(Duration.ofMinutes(2)) < 0);
  }

  @Test
  void forecastsNothingWithoutAnOptimum() {
    for (String yardsticks : List.of("bound", "none")) {
      ReferencePolicies references = ReferencePolicies.parse("", yardsticks);
      assertEquals(Optional.empty(), forecast(references, Scenario.MAX_STEPS));
    }
  }

  private static Optional<OptimumTime.Forecast> forecast(ReferencePolicies references, int steps) {
    Scenario site = new RandomSite(new RandomField(6, 9, RandomSite.AREA, 1), 10).scenario();
    DetectionModel model = CATALOGUE.detection("oodpcvs-2025:level=discern");
    Detection detection = new Detection(model.name(), model, model.defaultThreshold());
    RunPlan plan = new RunPlan(site, detection, "independent-greedy", steps, 0, 1);
    return new OptimumTime(CATALOGUE, 2).forecast(List.of(plan), references);
  }
}
