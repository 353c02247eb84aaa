package org.hificamsim.bench;

import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Extent;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.silhouette.HiddenShares;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.movement.Movements;
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
 * Measures the milliseconds to compute which share of each of 500 people is hidden from each of 10
 * cameras, in a square field with walls of 2 to 20 m.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(value = 2, jvmArgs = "-XX:+UseSerialGC")
public class HiddenSharesBenchmark {
  private static final int CAMERAS = 10;
  private static final int PEOPLE = 500;
  private static final double MOUNT_HEIGHT = 4;

  @Param({"30", "60", "120"})
  private int side;

  @Param({"0", "200"})
  private int walls;

  @Param({"false", "true"})
  private boolean heights;

  /** The height of walls, in metres. */
  @Param("Infinity")
  private double top;

  private final SplittableRandom random = new SplittableRandom(1);
  private World world;
  private HiddenShares shares;

  /** Places cameras, people and walls at random. */
  @Setup
  public void start() {
    Scenario scenario =
        new Scenario("crowd", new Field(0, side, 0, side))
            .with(Scenario.CAMERAS, IntStream.range(0, CAMERAS).mapToObj(this::camera).toList())
            .with(Scenario.TARGETS, IntStream.range(0, PEOPLE).mapToObj(this::person).toList())
            .with(Scenario.OBSTACLES, Stream.generate(this::wall).limit(walls).toList());
    world = new World(scenario, Movements.registry(), 0);
    shares = new HiddenShares(world);
  }

  private CameraSpec camera(int number) {
    CameraSpec camera = new CameraSpec("c" + number, coordinate(), coordinate(), side);
    return heights ? camera.with(CameraSpec.Z, MOUNT_HEIGHT) : camera;
  }

  private TargetSpec person(int number) {
    return new TargetSpec(number, coordinate(), coordinate()).withExtent(Extent.PERSON);
  }

  private Obstacle wall() {
    double x = coordinate();
    double y = coordinate();
    double angle = random.nextDouble(2 * Math.PI);
    double length = random.nextDouble(2, 20);
    return new Obstacle.Wall(
        x, y, x + length * Math.cos(angle), y + length * Math.sin(angle), 0, 0, top);
  }

  private double coordinate() {
    return random.nextDouble(side);
  }

  /** Computes all shares of a step. */
  @Benchmark
  public double step() {
    shares.begin();
    double sum = 0;
    for (int camera = 0; camera < CAMERAS; camera++) {
      for (int person = 0; person < PEOPLE; person++) {
        sum += shares.share(camera, person);
      }
    }
    return sum;
  }
}
