package org.hificamsim.bench;

import java.util.concurrent.TimeUnit;
import org.hificamsim.network.NetworkRun;
import org.hificamsim.network.agent.ScheduleKind;
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
 * Measures the microseconds per step of CamSim's network, and counts the StartSearch messages that
 * a step delivers. Fields are random and as dense as the cluster scenario, with half as many
 * targets as cameras. {@code -p cameras=...} and {@code -p communicationPolicy=...} set the
 * network.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(value = 1, jvmArgs = "-XX:+UseSerialGC") // as the launcher has it
public class NetworkGrowthBenchmark {
  @Param({"100", "200", "400", "800", "1600"})
  private int cameras;

  @Param({"PASSIVE"})
  private ScheduleKind schedule;

  @Param({"0"})
  private int communicationPolicy;

  private NetworkRun run;
  private long messages;
  private long steps;

  /** Makes the scenario and starts the run. */
  @Setup
  public void start() {
    RandomField field = new RandomField(cameras, cameras / 2, RandomField.CLUSTER_AREA, 1);
    run = AuctionRun.of(field.scenario(), schedule, communicationPolicy);
  }

  /** Prints how many messages a step delivered. */
  @TearDown
  public void end() {
    System.out.printf("%n%d StartSearch messages a step%n", messages / steps);
  }

  /** Makes one step. */
  @Benchmark
  public double step() {
    run.simulation().step();
    messages += run.network().figures().communication();
    steps++;
    return run.network().figures().utility();
  }
}
