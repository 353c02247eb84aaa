package org.hificamsim.bench;

import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.TargetOcclusion;
import org.hificamsim.core.obstacle.VisibleRegion;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.openjdk.jmh.infra.Blackhole;

/**
 * Measures the nanoseconds to tell whether a camera sees a target, with the look-up of a visible
 * region and by testing each wall; to tell whether another target hides it; and to construct the
 * look-up. Walls of 2 to 20 m stand in a field of 60 m x 40 m; all places are random.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(value = 2, jvmArgs = "-XX:+UseSerialGC")
public class VisibleRegionBenchmark {
  private static final int CAMERAS = 14;
  private static final int TARGETS = 512;
  private static final int DISCS = 8;

  @Param({"40", "200"})
  private int walls;

  private final SplittableRandom random = new SplittableRandom(1);
  private final double[] cameraX = coordinates(CAMERAS, 60);
  private final double[] cameraY = coordinates(CAMERAS, 40);
  private final double[] x = coordinates(TARGETS, 60);
  private final double[] y = coordinates(TARGETS, 40);
  private final double[] radius = random.doubles(TARGETS, 0.2, 0.5).toArray();
  private final VisibleRegion[] regions = new VisibleRegion[CAMERAS];
  private Obstacles obstacles;

  private double[] coordinates(int count, double end) {
    return random.doubles(count, 0, end).toArray();
  }

  /** Puts up the walls, and looks from all cameras. */
  @Setup
  public void start() {
    obstacles = new Obstacles(Stream.generate(this::wall).limit(walls).toList());
    double seen = 0;
    for (int camera = 0; camera < CAMERAS; camera++) {
      regions[camera] = region(camera);
      for (int target = 0; target < TARGETS; target++) {
        seen += regions[camera].transmittance(x[target], y[target]) > 0 ? 1 : 0;
      }
    }
    System.out.println(Math.round(100 * seen / CAMERAS / TARGETS) + " % seen");
  }

  private Obstacle wall() {
    double fromX = random.nextDouble(60);
    double fromY = random.nextDouble(40);
    double angle = random.nextDouble(2 * Math.PI);
    double length = random.nextDouble(2, 20);
    return new Obstacle.Wall(
        fromX, fromY, fromX + length * Math.cos(angle), fromY + length * Math.sin(angle), 0);
  }

  private VisibleRegion region(int camera) {
    return VisibleRegion.of(obstacles, cameraX[camera], cameraY[camera]);
  }

  /** Returns how much light passes, by the look-up. */
  @Benchmark
  @OperationsPerInvocation(CAMERAS * TARGETS)
  public double transmittance() {
    double light = 0;
    for (VisibleRegion region : regions) {
      for (int target = 0; target < TARGETS; target++) {
        light += region.transmittance(x[target], y[target]);
      }
    }
    return light;
  }

  /** Returns whether light passes, by testing each wall. */
  @Benchmark
  @OperationsPerInvocation(CAMERAS * TARGETS)
  public int seesWithoutLookUp() {
    int seen = 0;
    for (int camera = 0; camera < CAMERAS; camera++) {
      for (int target = 0; target < TARGETS; target++) {
        seen += obstacles.clear(cameraX[camera], cameraY[camera], x[target], y[target]) ? 1 : 0;
      }
    }
    return seen;
  }

  /** Tests for each of eight targets whether another one hides it. */
  @Benchmark
  @OperationsPerInvocation(CAMERAS * DISCS)
  public int hiddenByTargets() {
    int hidden = 0;
    for (int camera = 0; camera < CAMERAS; camera++) {
      for (int disc = 0; disc < DISCS; disc++) {
        hidden +=
            TargetOcclusion.hidden(cameraX[camera], cameraY[camera], disc, x, y, radius, DISCS)
                ? 1
                : 0;
      }
    }
    return hidden;
  }

  /** Constructs the look-up of each camera. */
  @Benchmark
  @OperationsPerInvocation(CAMERAS)
  public void construction(Blackhole made) {
    for (int camera = 0; camera < CAMERAS; camera++) {
      made.consume(region(camera));
    }
  }
}
