package org.hificamsim.bench;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.engine.Workers;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.world.World;
import org.hificamsim.network.CamSimScenario;
import org.hificamsim.network.Network;
import org.hificamsim.network.NetworkSettings;
import org.hificamsim.network.agent.ScheduleKind;
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
 * Microseconds per step of CamSim's network, as {@code camsim} runs it; {@code -p file=...} takes
 * any scenario.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(2)
public class NetworkBenchmark {
  @Param({"scenarios/tutorial-camsim.xml"})
  private String file;

  @Param({"ACTIVE", "PASSIVE"})
  private ScheduleKind schedule;

  @Param({"0"})
  private int comm;

  private Simulation simulation;
  private Network network;

  /** Reads the scenario and starts the run. */
  @Setup
  public void start() {
    Catalogue catalogue = Catalogue.load();
    NetworkSettings settings = NetworkSettings.CAMSIM.withAll(schedule, comm);
    Scenario scenario =
        ScenarioReader.read(Path.of(file), catalogue.movements().names()::contains, warning -> {})
            .with(Scenario.ZOOMS, List.of());
    World world = new World(CamSimScenario.as(scenario, settings), catalogue.movements(), 0);
    Detection detection = Detection.of(catalogue.detection("camsim-visibility"));
    network = new Network(world, detection, settings, 0);
    ZoomPolicy zooms = catalogue.policies().create("zoom-out");
    simulation = new Simulation(world, detection, zooms, network, 0, List.of(), Workers.CALLER);
  }

  /** One step. */
  @Benchmark
  public double step() {
    simulation.step();
    return network.figures().utility();
  }
}
