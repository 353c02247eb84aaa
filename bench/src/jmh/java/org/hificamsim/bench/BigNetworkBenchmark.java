package org.hificamsim.bench;

import java.util.List;
import java.util.concurrent.TimeUnit;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Cooperation;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.engine.Workers;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.generate.RandomField;
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
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Microseconds per step of random fields at the cluster scenario's density with 0.6 targets per
 * camera: {@code -p cameras=...}, {@code -p threads=...}.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(value = 1, jvmArgs = "-XX:+UseSerialGC") // as the launcher has it
public class BigNetworkBenchmark {
  @Param({"100", "1000", "10000", "100000"})
  private int cameras;

  @Param({"epsilon-greedy", "sarsa"})
  private String policy;

  @Param({"hifi:orb-lin"})
  private String detection;

  @Param({"1"})
  private int threads;

  private Workers workers;
  private Simulation simulation;

  /** Makes the scenario and starts the run. */
  @Setup
  public void start() {
    Catalogue catalogue = Catalogue.load();
    workers = Workers.of(threads);
    simulation =
        new Simulation(
            new World(RandomField.ofCameras(cameras, 1).scenario(), catalogue.movements(), 0),
            Detection.of(catalogue.detection(detection)),
            catalogue.policies().create(policy),
            Cooperation.NONE,
            0,
            List.of(),
            workers);
  }

  /** Ends the threads. */
  @TearDown
  public void end() {
    workers.close();
  }

  /** One step. */
  @Benchmark
  public int step() {
    simulation.step();
    return simulation.coverage().kMin();
  }
}
