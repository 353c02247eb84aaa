package org.hificamsim.experiments.bench;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.world.World;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Steps per second of a whole run: move, decide, observe, learn, measure. */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(2)
public class StepBenchmark {
  @Param({"cluster-random"})
  private String scenario;

  @Param({"hifi:orb-lin", "camsim-range"})
  private String detection;

  @Param({"zoom-out", "epsilon-greedy", "optimal"})
  private String policy;

  private Simulation simulation;

  /** Reads the scenario and starts the run. */
  @Setup
  public void start() {
    Catalogue catalogue = Catalogue.load();
    Scenario read =
        ScenarioReader.read(
            Path.of("scenarios", scenario + ".xml"),
            catalogue.movements().names()::contains,
            warning -> {});
    DetectionModel model = catalogue.detection(detection);
    simulation =
        new Simulation(
            new World(read, catalogue.movements(), 0),
            Detection.of(model),
            catalogue.policies().create(policy),
            0,
            List.of());
  }

  /** One step. */
  @Benchmark
  public int step() {
    simulation.step();
    return simulation.coverage().kMin();
  }
}
