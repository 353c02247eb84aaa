package org.hificamsim.bench;

import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.hificamsim.bench.plain.PlainAuctions;
import org.hificamsim.core.scenario.Scenario;
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
 * Measures the microseconds per step of CamSim's auctions (Passive, Broadcast), in our engine and
 * with plain objects.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(2)
public class AuctionPeerBenchmark {
  /** The runs of both, of the same scenario. */
  @State(Scope.Thread)
  public static class Task {
    @Param("")
    private String scenario;

    private NetworkRun ours;
    private PlainAuctions plain;

    /** Starts both runs. */
    @Setup
    public void start() {
      Scenario read = ScenarioReader.read(Path.of(scenario), name -> true, warning -> {});
      ours = AuctionRun.of(read, ScheduleKind.PASSIVE, 0);
      plain = new PlainAuctions(read, 0);
    }
  }

  /** Makes one step of our engine. */
  @Benchmark
  public double ours(Task task) {
    task.ours.simulation().step();
    return task.ours.network().figures().utility();
  }

  /** Makes one step of the plain objects. */
  @Benchmark
  public double plain(Task task) {
    return task.plain.step().utility();
  }
}
