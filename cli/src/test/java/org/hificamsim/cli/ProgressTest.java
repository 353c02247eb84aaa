package org.hificamsim.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.runs.RunPlan;
import org.junit.jupiter.api.Test;

class ProgressTest {
  private final StringWriter output = new StringWriter();

  private Progress progress(String task, String unit, long total, Duration quiet) {
    return new Progress(task, unit, total, new PrintWriter(output, true), quiet);
  }

  /** Returns the last line without its bar. */
  private String lastLine() {
    List<String> lines = output.toString().lines().toList();
    return lines.get(lines.size() - 1).replaceAll("\\[.*?\\]", "");
  }

  /** Another call has measured 36 of 60 photos before. */
  @Test
  void countsResumedWorkAsDoneButNotForSpeed() throws InterruptedException {
    try (Progress progress = progress("lab", " photos", 60, Duration.ZERO)) {
      progress.resume(36);
      for (int photo = 0; photo < 5; photo++) {
        Thread.sleep(300);
        progress.advance();
      }
    }
    assertTrue(lastLine().matches("lab +68% .*41/60 photos .*"), output.toString());
    String perSecond = lastLine().replaceFirst(".* ([\\d.]+) photos/s.*", "$1");
    assertTrue(Double.parseDouble(perSecond) < 10, output.toString());
  }

  @Test
  void endsAtHundredPercent() {
    try (Progress progress = progress("run ring", " steps", 2000, Duration.ZERO)) {
      for (int step = 0; step < 2000; step++) {
        progress.advance();
      }
    }
    assertTrue(lastLine().matches("run ring +100% .*2000/2000 steps .*"), output.toString());
  }

  @Test
  void shortWorkPrintsNothing() {
    try (Progress progress = progress("run ring", " steps", 1, Duration.ofSeconds(2))) {
      progress.advance();
    }
    assertEquals("", output.toString());
  }

  /** The scenario of MATE has 300 steps, for example, and that of HiT-MAC 100. */
  @Test
  void countsEachRunOnceWhateverItsLength() throws IOException {
    Path file = Path.of("..", "scenarios", "hit-mac.xml");
    Scenario scenario = ScenarioReader.read(file, name -> true, warning -> {});
    Detection detection = Detection.of(new GeometricDetection());
    List<RunPlan> plans =
        IntStream.of(300, 100)
            .mapToObj(steps -> new RunPlan(scenario, detection, "zoom-out", steps, 0, 20))
            .toList();
    assertEquals(40, runs(plans, plans.stream().mapToLong(RunPlan::work).sum()));
    assertEquals(500, runs(plans, 500 * 300));
  }

  private static long runs(List<RunPlan> plans, long steps) {
    return new BatchRun.Runs(plans, plans, steps, true).count();
  }
}
