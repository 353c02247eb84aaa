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
 * The least that Broadcast could cost if its messages were brought one by one: nanoseconds for a
 * StartSearch that every camera takes note of, which is who searches and since when, in what that
 * camera knows of the target. Divided by the cameras it is the limit for each message.
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

  /** Makes what the cameras know: half as many targets as cameras, as on the fields of growth. */
  @Setup
  public void start() {
    searcher = new int[cameras][cameras / 2];
    since = new long[cameras][cameras / 2];
  }

  /** One camera searches for one target, and all others hear of it. */
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
