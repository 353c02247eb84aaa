package org.hificamsim.bench;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.hificamsim.bench.plain.PlainSimulation;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
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

/**
 * Measures the microseconds per step of our engine and of the plain objects, with the same scenario
 * and policy.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(2)
public class PeerBenchmark {
  /** The scenario and policy that both run. */
  @State(Scope.Thread)
  public static class Task {
    @Param({"bench/cluster-8.xml"})
    private String scenario;

    @Param({"zoom-out", "epsilon-greedy", "sarsa"})
    private String policy;

    private final Catalogue catalogue = Catalogue.load();

    private Scenario read() {
      return ScenarioReader.read(
          Path.of(scenario), catalogue.movements().names()::contains, warning -> {});
    }
  }

  /** A run of our engine. */
  @State(Scope.Thread)
  public static class Ours {
    private Simulation simulation;

    /** Starts the run. */
    @Setup
    public void start(Task task) {
      simulation =
          new Simulation(
              new World(task.read(), task.catalogue.movements(), 0),
              Detection.of(task.catalogue.detection("hifi:orb-lin")),
              task.catalogue.policies().create(task.policy),
              0,
              List.of());
    }
  }

  /** A run of the plain objects. */
  @State(Scope.Thread)
  public static class Plain {
    private PlainSimulation simulation;

    /** Starts the run. */
    @Setup
    public void start(Task task) {
      simulation = new PlainSimulation(task.read(), "hifi:orb-lin", task.policy, 0.1, 0);
    }
  }

  /** Makes one step of our engine. */
  @Benchmark
  public int ours(Ours run) {
    run.simulation.step();
    return run.simulation.coverage().kMin();
  }

  /** Makes one step of the plain objects. */
  @Benchmark
  public int plain(Plain run) {
    return run.simulation.step();
  }
}
