package org.hificamsim.bench;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.core.scenario.file.TrackWriter;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.generate.RandomField;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Measures the microseconds per step with a thousand targets that move {@code Straight}, and with
 * the same targets on recorded tracks, with a sample in each step. Cameras see the same in both, so
 * that times differ by the movement only.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(value = 3, jvmArgs = "-XX:+UseSerialGC") // as the launcher has it
public class TracksBenchmark {
  private static final int STEPS = 2000;

  /** The square metres for each camera, as in the thesis. */
  private static final double AREA = 42.9;

  @Param({"Straight", "Tracks"})
  private String movement;

  @Param({"1000"})
  private int targets;

  @Param({"50"})
  private int cameras;

  private final Catalogue catalogue = Catalogue.load();
  private Scenario scenario;
  private Simulation simulation;

  /** Makes the scenario, and records its targets if these are to move on tracks. */
  @Setup(Level.Trial)
  public void make() throws IOException {
    scenario = new RandomField(cameras, targets, AREA, 1).scenario();
    if (movement.equals("Tracks")) {
      scenario = recorded();
    }
  }

  private Scenario recorded() throws IOException {
    Path folder = Files.createTempDirectory("tracks-benchmark");
    Path file = folder.resolve("recorded.xml");
    Path tracks = folder.resolve("recorded.tracks");
    try (BufferedWriter out = Files.newBufferedWriter(tracks)) {
      record(new TrackWriter(out, 1, 0));
    }
    Scenario empty = scenario.with(Scenario.TARGETS, List.of());
    Files.writeString(file, ScenarioWriter.write(empty, "recorded.tracks"));
    Scenario read =
        ScenarioReader.read(file, catalogue.movements().names()::contains, warning -> {});
    Files.delete(tracks);
    Files.delete(file);
    Files.delete(folder);
    return read;
  }

  private void record(TrackWriter writer) throws IOException {
    double[][] x = new double[STEPS][];
    double[][] y = new double[STEPS][];
    World world = new World(scenario, catalogue.movements(), 0);
    Targets moving = world.targets();
    for (int step = 0; step < STEPS; step++) {
      world.fireEvents(step);
      x[step] = new double[targets];
      y[step] = new double[targets];
      for (int target = 0; target < targets; target++) {
        x[step][target] = moving.x(target);
        y[step][target] = moving.y(target);
      }
      world.moveTargets();
    }
    for (int target = 0; target < targets; target++) {
      writer.target(target, moving.size(target));
      for (int step = 0; step < STEPS; step++) {
        writer.sample(step, x[step][target], y[step][target]);
      }
    }
  }

  /** Starts a run. */
  @Setup(Level.Invocation)
  public void start() {
    simulation =
        new Simulation(
            new World(scenario, catalogue.movements(), 0),
            Detection.of(catalogue.detection("camsim-range")),
            catalogue.policies().create("zoom-out"),
            0,
            List.of());
  }

  /** Runs all steps; returns the detections, which must be equal for both movements. */
  @Benchmark
  @OperationsPerInvocation(STEPS)
  public long run() {
    long detections = 0;
    for (int step = 0; step < STEPS; step++) {
      simulation.step();
      detections += simulation.coverage().detections();
    }
    return detections;
  }
}
