package org.hificamsim.bench;

import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.network.NetworkRun;
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
 * Measures the microseconds per step of CamSim's network, as {@code camsim} runs it. {@code -p
 * file=...} sets the scenario.
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
  private int communicationPolicy;

  private NetworkRun run;

  /** Reads the scenario and starts the run. */
  @Setup
  public void start() {
    run =
        AuctionRun.of(
            ScenarioReader.read(Path.of(file), name -> true, warning -> {}),
            schedule,
            communicationPolicy);
  }

  /** Makes one step. */
  @Benchmark
  public double step() {
    run.simulation().step();
    return run.network().figures().utility();
  }
}
