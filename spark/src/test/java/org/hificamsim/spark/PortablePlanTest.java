package org.hificamsim.spark;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.runs.RunPlan;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PortablePlanTest {
  private static final Catalogue CATALOGUE = Catalogue.load();
  private static final Path FILE =
      Path.of(System.getProperty("hificamsim.root", "."), "scenarios", "cluster-scripted.xml");

  private static final String BOXES =
      """
      {"schema": "hificamsim-model", "version": 4, "name": "mine", "falseAlarms": 0.5,
       "found": {"intercept": 2, "height": 3, "hidden": 7, "floor": 0, "ceiling": 0.95,
                 "width": {"slope": 1.5, "usualShape": 0.34}}}
      """;

  /** A model that is not in the catalogue. */
  private record Unknown(String name) implements DetectionModel {
    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return 1;
    }
  }

  @Test
  void restoresEveryModelOfTheCatalogue() {
    int models = 0;
    for (String name : CATALOGUE.detections().names()) {
      RunPlan plan = plan(CATALOGUE.detection(name));
      assertEquals(name, PortablePlan.of(plan, CATALOGUE).plan(CATALOGUE).detection().name());
      models++;
    }
    assertTrue(models > 20, models + " models");
  }

  @Test
  void restoresRuleOfChance() {
    DetectionRule rule = DetectionRule.parse("chance:alpha=0.01,memory=5");
    Detection detection = Detection.by(rule, "mine", CATALOGUE.detection("hifi:orb-lin"));
    RunPlan plan = plan(CATALOGUE.detection("hifi:orb-lin"));
    RunPlan byChance =
        new RunPlan(plan.scenario(), detection, plan.policy(), plan.steps(), plan.seed(), 1);
    Detection back = PortablePlan.of(byChance, CATALOGUE).plan(CATALOGUE).detection();
    assertEquals(rule, back.rule());
    assertEquals(detection.threshold(), back.threshold());
  }

  @Test
  void restoresModelFileOfBoxes(@TempDir Path folder) throws IOException {
    Path file = Files.writeString(folder.resolve("mine.json"), BOXES);
    DetectionModel model = CATALOGUE.detection(file.toString());
    RunPlan plan = plan(model);
    Detection detection = Detection.by(model.defaultRule(), "mine", model);
    RunPlan byProbability =
        new RunPlan(plan.scenario(), detection, plan.policy(), plan.steps(), plan.seed(), 1);
    Detection back = PortablePlan.of(byProbability, CATALOGUE).plan(CATALOGUE).detection();
    assertEquals(model, back.model());
    assertTrue(back.model().dependsOnHiddenShare());
    assertEquals("probability", back.rule().text());
  }

  @Test
  void rejectsModelUnknownToOtherMachines() {
    InputException fault =
        assertThrows(
            InputException.class, () -> PortablePlan.of(plan(new Unknown("mine")), CATALOGUE));
    assertTrue(fault.getMessage().contains("unknown detection 'mine'"), fault.getMessage());
  }

  @Test
  void rejectsPlanThatDiffersOnExecutor() {
    PortablePlan here = PortablePlan.of(plan(CATALOGUE.detection("geometric")), CATALOGUE);
    PortablePlan there =
        new PortablePlan(
            here.scenario(),
            here.xml(),
            PortablePlan.PortableDetection.of(
                new Detection("geometric", CATALOGUE.detection("hifi:orb-lin"), 0.5)),
            here.keptValues(),
            here.key());
    InputException fault = assertThrows(InputException.class, () -> there.plan(CATALOGUE));
    assertEquals(
        "scenario 'cluster-scripted' with detection 'geometric': detection 'geometric' is another"
            + " on an executor than here, expected the same version and jars",
        fault.getMessage());
  }

  private static RunPlan plan(DetectionModel model) {
    Scenario scenario =
        ScenarioReader.read(FILE, CATALOGUE.movements().names()::contains, warning -> {});
    return new RunPlan(
        scenario, new Detection(model, model.defaultThreshold()), "zoom-out", 10, 0, 1);
  }
}
