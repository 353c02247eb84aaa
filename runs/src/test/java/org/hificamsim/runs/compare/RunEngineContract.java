package org.hificamsim.runs.compare;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.Headings;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.junit.jupiter.api.DynamicTest;

/**
 * The tests that every {@link RunEngine} has to pass.
 *
 * @param engines makes a new, configured instance
 */
public record RunEngineContract(Supplier<RunEngine> engines) {
  private static final Path SCENARIOS =
      Path.of(System.getProperty("hificamsim.root", ".")).resolve("scenarios");
  private static final Catalogue CATALOGUE = Catalogue.load();
  private static final int STEPS = 60;
  private static final int REPEATS = 3;

  private static final String MODEL =
      """
      {"schema": "hificamsim-model", "version": 1, "name": "mine",
       "f": {"type": "linear", "z": -18.82, "q": -2.0, "d": 0.2, "intercept": 2.47},
       "g": {"slope": 0.571, "intercept": 0.026}, "threshold": 0.05}
      """;

  /** The tests, named after what they assert. */
  public Stream<DynamicTest> tests() {
    return Stream.of(
        dynamicTest("returnsEachRunOnce", this::returnsEachRunOnce),
        dynamicTest("computesSameResultsAsSingleRuns", this::computesSameResultsAsSingleRuns),
        dynamicTest("needsNoFilesAfterPlansAreRead", this::needsNoFilesAfterPlansAreRead),
        dynamicTest("distinguishesModelsOfSameName", this::distinguishesModelsOfSameName),
        dynamicTest("computesOnlyGivenTasks", this::computesOnlyGivenTasks),
        dynamicTest("acceptsEmptyListOfTasks", this::acceptsEmptyListOfTasks),
        dynamicTest("endsWithFaultOfRun", this::endsWithFaultOfRun),
        dynamicTest("endsWithFaultOfReceiver", this::endsWithFaultOfReceiver));
  }

  private void returnsEachRunOnce() throws IOException {
    List<RunTask> taken = new ArrayList<>();
    engines
        .get()
        .run(
            plans(),
            all(plans()),
            (task, run) -> {
              synchronized (taken) {
                taken.add(task);
              }
            });
    assertEquals(all(plans()).size(), taken.size());
    assertTrue(taken.containsAll(all(plans())), taken.toString());
  }

  private void computesSameResultsAsSingleRuns() throws IOException {
    assertSameAsSingleRuns(plans(), all(plans()));
  }

  private void needsNoFilesAfterPlansAreRead() throws IOException {
    Path folder = Files.createTempDirectory("engine");
    Path model = Files.writeString(folder.resolve("model.json"), MODEL);
    Path copy = Files.copy(SCENARIOS.resolve("ring-random.xml"), folder.resolve("a.b copy.xml"));
    List<RunPlan> plans = List.of(plan(read(copy), model.toString(), "zoom-out"));
    for (Path file : List.of(model, copy, folder)) {
      Files.delete(file);
    }
    assertSameAsSingleRuns(plans, all(plans));
  }

  /** The file of a model changes while two plans are read. */
  private void distinguishesModelsOfSameName() throws IOException {
    Path model = Files.createTempFile("model", ".json");
    List<RunPlan> plans = new ArrayList<>();
    for (String intercept : List.of("0.026", "-0.2")) {
      Files.writeString(model, MODEL.replace("0.026", intercept));
      plans.add(plan(scenario("ring-random"), model.toString(), "zoom-out"));
    }
    Files.delete(model);
    assertSameAsSingleRuns(plans, all(plans));
    Map<RunTask, FinishedRun> runs = run(plans, all(plans));
    assertNotEquals(runs.get(new RunTask(0, 0)).result(), runs.get(new RunTask(1, 0)).result());
  }

  private void computesOnlyGivenTasks() throws IOException {
    assertSameAsSingleRuns(plans(), List.of(new RunTask(1, 2), new RunTask(0, 1)));
  }

  private void acceptsEmptyListOfTasks() throws IOException {
    assertTrue(run(plans(), List.of()).isEmpty());
  }

  private void endsWithFaultOfRun() {
    List<RunPlan> plans = List.of(plan(scenario("ring-random"), "geometric", "nothing"));
    InputException fault = assertThrows(InputException.class, () -> run(plans, all(plans)));
    assertTrue(fault.getMessage().startsWith("unknown policy 'nothing'"), fault.getMessage());
  }

  private void endsWithFaultOfReceiver() {
    RunPlan plan = plan(scenario("ring-random"), "geometric", "zoom-out");
    List<RunPlan> many =
        List.of(
            new RunPlan(
                plan.scenario(), plan.detection(), plan.policy(), 20_000, plan.seed(), 200));
    AtomicInteger taken = new AtomicInteger();
    IOException fault =
        assertThrows(
            IOException.class,
            () ->
                engines
                    .get()
                    .run(
                        many,
                        all(many),
                        (task, run) -> {
                          taken.incrementAndGet();
                          throw new IOException("disk full");
                        }));
    assertEquals("disk full", fault.getMessage());
    assertTrue(taken.get() < 200, taken + " of 200 were computed");
  }

  private void assertSameAsSingleRuns(List<RunPlan> plans, List<RunTask> tasks) throws IOException {
    Map<RunTask, FinishedRun> runs = run(plans, tasks);
    assertEquals(tasks.size(), runs.size());
    for (RunTask task : tasks) {
      FinishedRun alone =
          FinishedRun.of(new RunExecutor(CATALOGUE), plans.get(task.plan()), task.repeat());
      assertEquals(alone.result(), runs.get(task).result());
      assertArrayEquals(alone.kMin(), runs.get(task).kMin());
    }
  }

  private Map<RunTask, FinishedRun> run(List<RunPlan> plans, List<RunTask> tasks)
      throws IOException {
    Map<RunTask, FinishedRun> runs = new ConcurrentHashMap<>();
    engines.get().run(plans, tasks, runs::put);
    return runs;
  }

  private static List<RunTask> all(List<RunPlan> plans) {
    List<RunTask> tasks = new ArrayList<>();
    for (int plan = 0; plan < plans.size(); plan++) {
      for (int repeat = 0; repeat < plans.get(plan).repeats(); repeat++) {
        tasks.add(new RunTask(plan, repeat));
      }
    }
    return tasks;
  }

  /** Plans with built-in models, a renamed model, policies with options and a changed scenario. */
  private static List<RunPlan> plans() {
    Scenario ring = scenario("ring-random").with(Scenario.HEADINGS, Headings.AS_RADIANS);
    RunPlan plain = plan(ring, "camsim-range", "zoom-out");
    Detection other = new Detection("camsim-range@0.45", plain.detection().model(), 0.45);
    return List.of(
        plain,
        plan(ring, "lab:surf-svr-rbf", "sarsa:gamma=0.9,epsilon=0.1"),
        plan(scenario("cluster-scripted"), "hifi:orb-lin", "optimal"),
        new RunPlan(ring, other, "zoom-in", STEPS, 7, REPEATS));
  }

  private static RunPlan plan(Scenario scenario, String detection, String policy) {
    DetectionModel model = CATALOGUE.detection(detection);
    return new RunPlan(
        scenario, new Detection(model, model.defaultThreshold()), policy, STEPS, 7, REPEATS);
  }

  private static Scenario scenario(String name) {
    return read(SCENARIOS.resolve(name + ".xml"));
  }

  private static Scenario read(Path file) {
    return ScenarioReader.read(file, CATALOGUE.movements().names()::contains, warning -> {});
  }
}
