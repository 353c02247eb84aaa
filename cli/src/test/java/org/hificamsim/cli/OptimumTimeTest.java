package org.hificamsim.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
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
  void saysInOneLineHowLongOptimaTakeAndWhatBoundsThem() {
    String said = said(ReferencePolicies.OPTIMUM, Scenario.MAX_STEPS);
    assertEquals(1, said.lines().count(), said);
    assertTrue(
        said.matches(
            "the optimum of random-6 takes up to \\S+ s a step, all optima up to \\d+:\\d\\d hours;"
                + " --yardsticks bound takes a small part of it\\R"),
        said);
  }

  @Test
  void saysNothingWhereTheyAreQuickOrNotRun() {
    assertEquals("", said(ReferencePolicies.OPTIMUM, 10));
    assertEquals("", said(ReferencePolicies.parse("", "bound"), Scenario.MAX_STEPS));
    assertEquals("", said(ReferencePolicies.parse("", "none"), Scenario.MAX_STEPS));
  }

  private static String said(ReferencePolicies references, int steps) {
    Scenario site = new RandomSite(new RandomField(6, 9, RandomSite.AREA, 1), 10).scenario();
    DetectionModel model = CATALOGUE.detection("oodpcvs-2025:level=discern");
    Detection detection = new Detection(model.name(), model, model.defaultThreshold());
    StringWriter err = new StringWriter();
    new OptimumTime(CATALOGUE, 2)
        .tell(
            List.of(new RunPlan(site, detection, "independent-greedy", steps, 0, 1)),
            references,
            new PrintWriter(err, true));
    return err.toString();
  }
}
