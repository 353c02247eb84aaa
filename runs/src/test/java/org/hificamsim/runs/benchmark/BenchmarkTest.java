package org.hificamsim.runs.benchmark;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.generate.SiteLayout;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class BenchmarkTest {
  private static final Path SCENARIOS =
      Path.of(System.getProperty("hificamsim.root", "..")).resolve("scenarios");
  private static final Benchmark BENCHMARK =
      Benchmark.read(SCENARIOS.resolve(Benchmark.FILE), Catalogue.load());

  @TempDir Path folder;

  static List<String> names() {
    return BENCHMARK.names();
  }

  @Test
  void hasTwelveTasks() {
    assertEquals(12, names().size());
  }

  /**
   * If this test fails, a task has changed: add it as the next version, and restore the old one.
   */
  @ParameterizedTest
  @MethodSource("names")
  void tasksAreUnchanged(String name) {
    BenchmarkTask task = BENCHMARK.task(name);
    assertEquals(task.hash(), task.digest(BENCHMARK.site(name)));
  }

  @Test
  void hashDependsOnEveryPartOfATask() {
    BenchmarkTask task = BENCHMARK.task("passage-v1");
    Scenario site = BENCHMARK.site("passage-v1");
    assertNotEquals(task.hash(), task.digest(site.with(Scenario.STEP_TIME, 0.25)));
    assertNotEquals(
        task.hash(),
        task.digest(
            site.withCameras(
                camera ->
                    camera.with(
                        org.hificamsim.core.scenario.spec.CameraSpec.X, camera.x() + 1e-9))));
  }

  @Test
  void rejectsTaskWhoseScaleWasEdited() throws IOException {
    String tasks = Files.readString(SCENARIOS.resolve(Benchmark.FILE));
    Double best = BENCHMARK.task("junction-v1").best().get(0);
    Files.copy(SCENARIOS.resolve("junction.xml"), folder.resolve("junction.xml"));
    Path file = folder.resolve(Benchmark.FILE);
    Files.writeString(file, tasks.replace(best.toString(), Double.toString(best / 2)));
    Benchmark edited = Benchmark.read(file, Catalogue.load());
    InputException fault =
        assertThrows(InputException.class, () -> edited.requireUnchanged("junction-v1"));
    assertTrue(fault.getMessage().contains("task junction-v1 was changed"), fault.getMessage());
  }

  /** Computes the scale of a task again. */
  @ParameterizedTest
  @MethodSource("names")
  void scaleAgreesWithRuns(String name) {
    BenchmarkTask task = BENCHMARK.task(name);
    RunPlan plan = BENCHMARK.plan(name, "optimal", BenchmarkTask.TESTING.get(9));
    RunResult best = new RunExecutor(BENCHMARK.catalogue()).repeat(plan, 0, List.of());
    assertEquals(task.best().get(9), best.bound() / plan.steps());
    assertEquals(task.proven().get(9), best.proof().orElseThrow().unprovenSteps() == 0);
    Episode zero = Episode.play(BENCHMARK, plan.withPolicy("zoom-out"));
    assertEquals(task.zoomOut().get(9), zero.score());
    assertTrue(task.best().get(9) > task.zoomOut().get(9));
  }

  @ParameterizedTest
  @MethodSource("names")
  void layoutsAreValidAndDiffer(String name) throws Exception {
    Set<String> drawn = new HashSet<>();
    List<Long> seeds = new ArrayList<>(BenchmarkTask.TESTING);
    for (long seed = 0; seed < 10; seed++) {
      seeds.add(seed);
    }
    for (long seed : seeds) {
      Scenario layout = BENCHMARK.layout(name, seed);
      Path file = folder.resolve(seed + ".xml");
      Files.writeString(file, ScenarioWriter.write(layout));
      List<String> warnings = new ArrayList<>();
      ScenarioReader.read(file, movement -> true, warnings::add);
      warnings.removeIf(warning -> warning.contains("lead outside the field"));
      assertEquals(List.of(), warnings, () -> name + " " + seed);
      assertTrue(drawn.add(ScenarioWriter.write(layout)), () -> name + " " + seed);
    }
  }

  @Test
  void trainingHasNoTestingLayout() {
    for (long seed : BenchmarkTask.TESTING) {
      String testing = ScenarioWriter.write(BENCHMARK.layout("campus-v1", seed));
      for (long other : new long[] {seed - BenchmarkTask.TRAINING, seed + BenchmarkTask.TRAINING}) {
        assertNotEquals(testing, ScenarioWriter.write(BENCHMARK.layout("campus-v1", other)));
      }
    }
    assertEquals(
        ScenarioWriter.write(BENCHMARK.layout("campus-v1", 5)),
        ScenarioWriter.write(BENCHMARK.layout("campus-v1", 5 - 7L * BenchmarkTask.TRAINING)));
  }

  /** The steps of testing come after all steps of training, and have targets. */
  @Test
  void recordingsBeginAtOtherTimesInTesting() {
    SiteLayout layout = BENCHMARK.task("street-v1").layout();
    int steps = BENCHMARK.task("street-v1").steps();
    assertTrue(layout.training().get(1) + steps <= layout.testing().get(0));
    long there =
        BENCHMARK
            .layout("street-v1", BenchmarkTask.TESTING.get(0))
            .everyTarget()
            .map(TargetSpec::track)
            .filter(track -> track.orElseThrow().time(0) <= 0)
            .count();
    assertTrue(there > 0);
  }

  @Test
  void mapLacksUnmappedObstacles() {
    Scenario warehouse = BENCHMARK.layout("warehouse-v1", 1);
    assertEquals(12, warehouse.obstacles().size());
    assertEquals(10, warehouse.find(Scenario.MAP).orElseThrow().size());
  }
}
