package org.hificamsim.reproduction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.ScoredRun;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;
import org.junit.jupiter.api.Test;

/** Tests the aggregation with made-up performances of two seeds. */
class Table81Test {
  private static final Path ROOT = Path.of(System.getProperty("hificamsim.root", "."));

  /** Performances of 10 and 20 of 20 (random), and of 30 and 60 of 120 (scripted). */
  private static ScoredRun run(RunPlan plan, int seed) {
    boolean scripted = plan.scenario().name().contains("scripted");
    double performance = (scripted ? 30.0 : 10.0) * (seed + 1);
    RunResult result = RunResult.of(seed, seed, Map.of(Metric.PERFORMANCE, performance));
    return new ScoredRun(result, scripted ? 120 : 20, Double.NaN, 0);
  }

  private static List<Table81.Cell> cells() {
    Map<String, Scenario> scenarios = new LinkedHashMap<>();
    for (String name : ReproductionPlans.scenarioNames()) {
      Path file = ROOT.resolve("scenarios").resolve(name + ".xml");
      scenarios.put(name, ScenarioReader.read(file, movement -> true, warning -> {}));
    }
    List<RunPlan> plans =
        new ReproductionPlans(
                scenarios, Settings.NONE.with(Setting.STEPS, "10").with(Setting.REPEAT, "2"))
            .plans(Catalogue.load()::detection);
    return new Table81(new Cases(plans.stream().map(Table81Test::result).toList())).cells();
  }

  private static CaseResult result(RunPlan plan) {
    List<ScoredRun> runs = IntStream.range(0, 2).mapToObj(seed -> run(plan, seed)).toList();
    return new CaseResult(plan, runs, new double[10], new double[10], new double[2][10]);
  }

  @Test
  void cellIsRatioOfSumsOverScenariosAndSeeds() {
    for (Table81.Cell cell : cells()) {
      assertEquals((10 + 20 + 30 + 60) / 280.0, cell.ours().mean(), 1e-12);
      assertTrue(cell.ours().low() < 40.0 / 140, "two seeds give a wide interval");
      assertTrue(cell.ours().high() > 80.0 / 140);
    }
  }

  @Test
  void readingsChangeOnlyTheCellsTheyConcern() {
    for (Table81.Cell cell : cells()) {
      PublishedCell published = cell.published();
      assertEquals(!published.hifi(), has(cell, Reading.HIFI_OPTIMUM));
      assertEquals(!published.hifi(), has(cell, Reading.HIFI_OPTIMUM_AT_45));
      assertEquals(!published.hifi(), has(cell, Reading.EQ_62));
      assertEquals(published.policy().equals("epsilon-greedy"), has(cell, Reading.EXPLORE_ANY));
      assertEquals(published.policy().equals("sarsa"), has(cell, Reading.LITERAL_REWARD));
      assertEquals(published.layout() == Layout.CLUSTER, has(cell, Reading.SCRIPT_AT_ORIGIN));
      assertEquals(
          1, cell.proportion(Reading.ONE_HOP_GREEDY), 1e-12); // here all policies are as good
    }
  }

  private static boolean has(Table81.Cell cell, Reading reading) {
    return !Double.isNaN(cell.proportion(reading));
  }

  @Test
  void distanceIsMeanOverNineCells() {
    List<Table81.Cell> cells = cells();
    Map<String, Distance> hifi = new LinkedHashMap<>();
    Distance.of(cells, 10, 2).stream()
        .filter(Distance::hifi)
        .forEach(distance -> hifi.put(distance.label(), distance));
    double ours = cells.get(0).ours().mean(); // the same in all cells here
    double published =
        cells.stream()
            .filter(cell -> cell.published().hifi())
            .mapToDouble(cell -> Math.abs(ours - cell.published().proportion()))
            .average()
            .orElseThrow();
    assertEquals(published, hifi.get("default").mean(), 1e-12);
    assertEquals(published, hifi.get("eq_6.2").mean(), 1e-12); // no hi-fi cell is read otherwise
    double oneHop = 1 - (.50 + .92 + .60 + .61 + .94 + .73 + .44 + .93 + .70) / 9;
    assertEquals(oneHop, hifi.get("over_one_hop").mean(), 1e-12);
    assertEquals(1, hifi.get("default").nearCells()); // the cluster's zoom-out, 0.44
  }

  @Test
  void hiFiColumnIsFittedAndCamSimsHeldOut() {
    for (Table81.Cell cell : cells()) {
      assertEquals(cell.published().hifi() ? FitRole.FITTED : FitRole.HELD_OUT, cell.role());
    }
  }

  @Test
  void reasonDoesNotCallCamSimsFormulaUnpublished() {
    for (Table81.Cell cell : cells()) {
      assertEquals(
          !cell.published().hifi() && cell.verdict() == Verdict.NOT_REPRODUCED,
          cell.judged().reason().contains("Eq 6.2"),
          cell.judged().reason());
    }
  }

  @Test
  void verdictsFollowTheRule() {
    Table81.Cell near =
        cells().stream().filter(cell -> cell.published().proportion() == 0.44).findFirst().get();
    assertEquals(Verdict.REPRODUCED, near.verdict());
    assertTrue(Math.abs(near.difference()) < 0.05);
  }
}
