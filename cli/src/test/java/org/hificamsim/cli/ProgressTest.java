package org.hificamsim.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.runs.RunPlan;
import org.junit.jupiter.api.Test;

class ProgressTest {
  private long now;
  private final StringWriter told = new StringWriter();

  private Progress progress(String task, String unit, long total) {
    return new Progress(
        task,
        unit,
        total,
        new PrintWriter(told, true),
        Progress.Telling.LINES,
        () -> TimeUnit.SECONDS.toNanos(now));
  }

  /** 36 of 60 photos were measured before; each of the others takes five seconds. */
  @Test
  void workDoneBeforeCountsAsDoneAndPromisesNoSpeed() {
    Progress progress = progress("lab", " photos", 60);
    now = 3;
    progress.resume(36);
    for (int photo = 0; photo < 5; photo++) {
      now += 5;
      progress.advance();
    }
    assertEquals(
        List.of(
            "lab: 38 of 60 photos (63%), 0.2 photos/s, 0:01:50 left",
            "lab: 41 of 60 photos (68%), 0.2 photos/s, 0:01:35 left"),
        told.toString().lines().toList());
  }

  @Test
  void tellsSpeedAndTheTimeLeftAtThatSpeed() {
    Progress runs = progress("compare", " runs", 3000);
    Progress steps = progress("run ring", " steps", 8000);
    for (int step = 1; step < 2000; step++) {
      steps.advance();
    }
    now = 20;
    runs.advance();
    steps.advance();
    assertEquals(
        List.of(
            "compare: 1 of 3000 runs (0%), 0.1 runs/s, 16:39:40 left",
            "run ring: 2000 of 8000 steps (25%), 100 steps/s, 0:01:00 left"),
        told.toString().lines().toList());
  }

  @Test
  void nothingIsLeftAtTheEnd() {
    Progress progress = progress("run ring", " steps", 1);
    now = 11;
    progress.advance();
    assertEquals(
        "run ring: 1 of 1 steps (100%), 0.1 steps/s, 0:00:00 left", told.toString().strip());
  }

  /** As with MATE's 300 steps and HiT-MAC's 100. */
  @Test
  void runsOfScenariosThatDifferInStepsCountAsOneEach() throws IOException {
    Path file = Path.of("..", "scenarios", "hit-mac.xml");
    Scenario scenario = ScenarioReader.read(file, any -> true, warning -> {});
    Detection detection = Detection.of(new GeometricDetection());
    List<RunPlan> plans =
        IntStream.of(300, 100)
            .mapToObj(steps -> new RunPlan(scenario, detection, "zoom-out", steps, 0, 20))
            .toList();
    assertEquals(40, BatchRun.runs(plans, plans.stream().mapToLong(RunPlan::work).sum()));
    assertEquals(500, BatchRun.runs(plans, 500 * 300));
  }
}
