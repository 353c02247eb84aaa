package org.hificamsim.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.hificamsim.core.scenario.spec.TargetSpec;
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
 * Measures the microseconds per step with optics and walls. Cameras with 25 views each are at
 * random places between walls of 3 m, in a field whose size is proportional to their number.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(value = 2, jvmArgs = "-XX:+UseSerialGC") // as the launcher has it
public class ViewsBenchmark {
  private static final double SQUARE_METRES_PER_CAMERA = 600.0 / 14;

  @Param({"14"})
  private int cameras;

  @Param({"8"})
  private int targets;

  @Param({"40"})
  private int walls;

  @Param({"dori-2014:level=observe"})
  private String detection;

  @Param({"zoom-out", "epsilon-greedy", "sarsa", "optimal"})
  private String policy;

  @Param({"kmin"})
  private String objective;

  private final SplittableRandom random = new SplittableRandom(1);
  private Simulation simulation;

  /** Makes the scenario and starts the run. */
  @Setup
  public void start() {
    Catalogue catalogue = Catalogue.load();
    simulation =
        new Simulation(
            new World(scenario(), catalogue.movements(), 0),
            Detection.of(catalogue.detection(detection)),
            catalogue.policies().create(policy),
            0,
            List.of());
  }

  /** Makes one step. */
  @Benchmark
  public int step() {
    simulation.step();
    return simulation.coverage().kMin();
  }

  private Scenario scenario() {
    double half = Math.sqrt(SQUARE_METRES_PER_CAMERA * cameras) / 2;
    List<Obstacle> obstacles = new ArrayList<>();
    for (int i = 0; i < walls; i++) {
      double x = random.nextDouble(-half, half);
      double y = random.nextDouble(-half, half);
      double angle = random.nextDouble(Math.PI);
      obstacles.add(new Obstacle.Wall(x, y, x + 3 * Math.cos(angle), y + 3 * Math.sin(angle), 0));
    }
    Obstacles solid = new Obstacles(obstacles);
    return new Scenario("views", new Field(-half, half, -half, half))
        .with(Scenario.ORDER, StepOrder.COVERAGE)
        .with(Scenario.OBJECTIVE, Objective.parse(objective))
        .with(Scenario.OBSTACLES, obstacles)
        .with(Scenario.CAMERAS, cameras(half, solid))
        .with(Scenario.TARGETS, targets(half, solid));
  }

  private List<CameraSpec> cameras(double half, Obstacles solid) {
    OpticsSpec optics =
        new OpticsSpec("ptz")
            .with(OpticsSpec.PIXELS, 640)
            .with(OpticsSpec.ANGLES_OF_VIEW, List.of(8.0, 15.0, 25.0, 40.0, 58.0))
            .with(OpticsSpec.PANS, List.of(-60.0, -30.0, 0.0, 30.0, 60.0));
    List<CameraSpec> all = new ArrayList<>();
    while (all.size() < cameras) {
      double x = random.nextDouble(-half, half);
      double y = random.nextDouble(-half, half);
      if (solid.containing(x, y).isEmpty()) {
        all.add(
            new CameraSpec("c" + all.size(), x, y, 0)
                .with(CameraSpec.HEADING, random.nextDouble(360))
                .with(CameraSpec.VIEWING_ANGLE, 60)
                .with(CameraSpec.OPTICS, optics));
      }
    }
    return all;
  }

  private List<TargetSpec> targets(double half, Obstacles solid) {
    List<TargetSpec> all = new ArrayList<>();
    while (all.size() < targets) {
      double x = random.nextDouble(-half, half);
      double y = random.nextDouble(-half, half);
      if (solid.containing(x, y).isEmpty()) {
        all.add(
            new TargetSpec(all.size(), x, y)
                .with(TargetSpec.HEADING, random.nextDouble(360))
                .with(TargetSpec.SPEED, 0.25)
                .with(TargetSpec.MOVE, "Straight"));
      }
    }
    return all;
  }
}
