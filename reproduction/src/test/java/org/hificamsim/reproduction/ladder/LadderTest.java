package org.hificamsim.reproduction.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.reproduction.ladder.LadderResult.RungResult;
import org.hificamsim.reproduction.ladder.Rungs.Rung;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.ScoredRun;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;
import org.junit.jupiter.api.Test;

class LadderTest {
  private static final Path ROOT = Path.of(System.getProperty("hificamsim.root", "."));
  private static final Catalogue CATALOGUE = Catalogue.load();
  private static final Scenario RING =
      ScenarioReader.read(
          ROOT.resolve("scenarios/ring-random.xml"), movement -> true, warning -> {});

  /** A rung that changes the scenario only: it has one target. */
  private static final Rung ONE_TARGET =
      new Rung(
          "lonely",
          "no other targets",
          Optional.of("geometric"),
          scenario ->
              scenario
                  .with(Scenario.NAME, "lonely-ring")
                  .with(Scenario.TARGETS, scenario.targets().subList(0, 1)));

  private static Ladder ladder(Rung... rungs) {
    return new Ladder(
        List.of(RING),
        List.of(rungs),
        List.of("zoom-out", "zoom-in"),
        (rung, scenario) -> rung.detection(Settings.NONE, scenario, LadderTest::model));
  }

  private static DetectionModel model(String name) {
    return CATALOGUE.detection(name);
  }

  @Test
  void hasAllRungsWithDifferentNames() {
    Ladder ladder = ladder(Rungs.ofDetection().toArray(Rung[]::new));
    assertEquals(2 * Rungs.ofDetection().size(), ladder.plans(settings(1)).size());
    assertEquals(
        Rungs.ofDetection().size(),
        Rungs.ofDetection().stream().map(Rung::name).distinct().count());
  }

  @Test
  void topRungIsByChance() {
    List<RunPlan> plans = ladder(Rungs.ofDetection().toArray(Rung[]::new)).plans(settings(1));
    RunPlan top = plans.get(plans.size() - 1);
    assertEquals("hifi:orb-lin@chance", top.detection().name());
    assertTrue(plans.stream().anyMatch(plan -> plan.detection().name().equals("hifi:orb-lin")));
  }

  @Test
  void findsResultsOfChangedScenarioByOriginalName() {
    Ladder ladder = ladder(Rungs.ofDetection("geometric"), ONE_TARGET);
    List<RunPlan> plans = ladder.plans(settings(2));
    assertEquals(
        List.of("ring-random", "ring-random", "lonely-ring", "lonely-ring"),
        plans.stream().map(plan -> plan.scenario().name()).toList());
    assertEquals(1, plans.get(2).scenario().targets().size());
    LadderResult result =
        LadderResult.of(
            ladder,
            new Cases(plans.stream().map(LadderTest::madeUpResult).toList()),
            List.of(1.0, 2.0));
    List<RungResult> ring = result.inScenario("ring-random");
    assertEquals(List.of("geometric", "lonely"), names(ring));
    assertEquals(-1, ring.get(0).tau().mean());
    assertEquals(List.of("zoom-out"), ring.get(0).chosen());
    assertEquals(List.of("zoom-in"), ring.get(1).chosen());
    assertEquals(0.6, ring.get(0).share().mean(), 1e-12);
    assertEquals(0, ring.get(1).regret().mean());
    assertEquals(List.of("ring-random", RungResult.ALL), result.scenarios());
  }

  /** Zooming out gives 10, zooming in 4 of every 10 steps; with one target they are swapped. */
  private static CaseResult madeUpResult(RunPlan plan) {
    boolean lonely = plan.scenario().name().startsWith("lonely");
    boolean good = plan.policy().equals("zoom-out") != lonely;
    List<ScoredRun> runs =
        IntStream.range(0, 2)
            .mapToObj(seed -> RunResult.of(seed, seed, Map.of(Metric.MEAN_K_MIN, good ? 1 : 0.4)))
            .map(run -> new ScoredRun(run, 10, Double.NaN, 0))
            .toList();
    return new CaseResult(plan, runs, new double[10], new double[10], new double[2][10]);
  }

  private static Settings settings(int repeats) {
    return Settings.NONE.with(Setting.STEPS, "10").with(Setting.REPEAT, "" + repeats);
  }

  private static List<String> names(List<RungResult> results) {
    return results.stream().map(row -> row.rung().name()).toList();
  }

  @Test
  void rungWithoutRuleIgnoresRuleOfScenario() {
    Scenario chance = RING.withDetect(DetectionRule.parse("chance"));
    Rung rung = Rungs.ofDetection("hifi:orb-lin");
    assertTrue(rung.detection(Settings.NONE, chance, LadderTest::model).certain());
  }

  @Test
  void rejectsEqualRungs() {
    InputException fault =
        assertThrows(
            InputException.class,
            () -> ladder(Rungs.ofDetection("geometric"), Rungs.ofDetection("geometric@threshold")));
    assertTrue(fault.getMessage().contains("expected each once"), fault.getMessage());
  }
}
