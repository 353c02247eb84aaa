package org.hificamsim.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.world.World;
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

/**
 * Measures the nanoseconds of a step for each pair of a camera and a target, all within reach, by
 * rule of detection. The cost of chance is the difference from {@code threshold}.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(value = 2, jvmArgs = "-XX:+UseSerialGC")
public class ChanceBenchmark {
  private static final int CAMERAS = 14;
  private static final int TARGETS = 8;

  @Param({"threshold", "chance", "chance:memory=10"})
  private String rule;

  @Param({"hifi:orb-lin", "lab:orb-svr-rbf"})
  private String detection;

  private Simulation simulation;

  /** Starts a run in a field that every camera oversees. */
  @Setup
  public void start() {
    Catalogue catalogue = Catalogue.load();
    DetectionModel model = catalogue.detection(detection);
    simulation =
        new Simulation(
            new World(scenario(), catalogue.movements(), 0),
            Detection.by(DetectionRule.parse(rule), model.name(), model),
            catalogue.policies().create("zoom-out"),
            0,
            List.of());
  }

  private static Scenario scenario() {
    SplittableRandom random = new SplittableRandom(1);
    List<CameraSpec> cameras = new ArrayList<>();
    for (int i = 0; i < CAMERAS; i++) {
      double x = random.nextDouble(-2.5, 2.5);
      double y = random.nextDouble(-2.5, 2.5);
      cameras.add(new CameraSpec("c" + i, x, y, 7.5));
    }
    List<TargetSpec> targets = new ArrayList<>();
    for (int i = 0; i < TARGETS; i++) {
      targets.add(
          new TargetSpec(i, random.nextDouble(-2.5, 2.5), random.nextDouble(-2.5, 2.5))
              .with(TargetSpec.HEADING, random.nextDouble(360))
              .with(TargetSpec.SPEED, 0.5)
              .with(TargetSpec.MOVE, "Straight")
              .with(TargetSpec.STD, 0));
    }
    return new Scenario("dense", new Field(-2.5, 2.5, -2.5, 2.5))
        .with(Scenario.ORDER, StepOrder.COVERAGE)
        .with(Scenario.ZOOMS, List.of(2.5, 3.75, 5.0, 6.25, 7.5))
        .with(Scenario.CAMERAS, cameras)
        .with(Scenario.TARGETS, targets);
  }

  /** Makes one step. */
  @Benchmark
  @OperationsPerInvocation(CAMERAS * TARGETS)
  public int step() {
    simulation.step();
    return simulation.coverage().kMin();
  }
}
