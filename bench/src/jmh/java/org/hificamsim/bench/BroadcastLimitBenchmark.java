package org.hificamsim.bench;

import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
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
 * Measures a lower limit for the cost of Broadcast with messages that are delivered one by one. It
 * is the nanoseconds for a StartSearch message to all cameras, each of which only notes who
 * searches for the target and since when. Divided by the number of cameras, this is the limit per
 * message.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(value = 1, jvmArgs = "-XX:+UseSerialGC") // as the launcher has it
public class BroadcastLimitBenchmark {
  @Param({"100", "200", "400", "800", "1600"})
  private int cameras;

  private final SplittableRandom random = new SplittableRandom(1);
  private int[][] searcher;
  private long[][] since;
  private long time;

  /**
   * Creates the notes of each camera about each target; there are half as many targets as cameras,
   * as in {@link NetworkGrowthBenchmark}.
   */
  @Setup
  public void start() {
    searcher = new int[cameras][cameras / 2];
    since = new long[cameras][cameras / 2];
  }

  /** Lets one camera search for a target, and all others note it. */
  @Benchmark
  public long search() {
    int from = random.nextInt(cameras);
    int target = random.nextInt(cameras / 2);
    time++;
    for (int camera = 0; camera < cameras; camera++) {
      if (camera != from) {
        searcher[camera][target] = from;
        since[camera][target] = time;
      }
    }
    return time;
  }
}
