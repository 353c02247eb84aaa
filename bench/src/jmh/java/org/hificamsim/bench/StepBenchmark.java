package org.hificamsim.bench;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.world.World;
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
import org.openjdk.jmh.annotations.Warmup;

/**
 * Measures the microseconds per step of a whole run, in which targets move, and policies decide,
 * observe and learn. {@code -p targets=...} replaces the targets of the scenario, whose number the
 * thesis does not give, by that many at random places; 0 keeps them. {@code -p randomCameras=...}
 * replaces the scenario by a random field with that many cameras, at the density of the cluster
 * scenarios and with 0.6 targets per camera.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(value = 2, jvmArgs = "-XX:+UseSerialGC") // as the launcher has it
public class StepBenchmark {
  @Param({"cluster-random"})
  private String scenario;

  @Param({"8"})
  private int targets;

  @Param({"0"})
  private int randomCameras;

  @Param({"hifi:orb-lin", "camsim-range"})
  private String detection;

  @Param({"zoom-out", "epsilon-greedy", "sarsa", "qb-sarsa", "one-hop", "optimal"})
  private String policy;

  private Simulation simulation;

  /** Reads the scenario and starts the run. */
  @Setup
  public void start() {
    Catalogue catalogue = Catalogue.load();
    DetectionModel model = catalogue.detection(detection);
    simulation =
        new Simulation(
            new World(scenario(catalogue), catalogue.movements(), 0),
            Detection.of(model),
            catalogue.policies().create(policy),
            0,
            List.of());
  }

  private Scenario scenario(Catalogue catalogue) {
    if (randomCameras > 0) {
      return RandomField.ofCameras(randomCameras, 1).scenario();
    }
    Scenario read =
        ScenarioReader.read(
            Path.of("scenarios", scenario + ".xml"),
            catalogue.movements().names()::contains,
            warning -> {});
    return targets == 0 ? read : withRandomTargets(read);
  }

  private Scenario withRandomTargets(Scenario read) {
    SplittableRandom random = new SplittableRandom(1);
    Field field = read.field();
    List<TargetSpec> randomTargets = new ArrayList<>();
    for (int target = 0; target < targets; target++) {
      TargetSpec template = read.targets().get(0);
      randomTargets.add(
          template
              .with(TargetSpec.FEATURES, target)
              .with(TargetSpec.X, random.nextDouble(field.minX(), field.maxX()))
              .with(TargetSpec.Y, random.nextDouble(field.minY(), field.maxY()))
              .with(TargetSpec.HEADING, random.nextDouble(360)));
    }
    return read.with(Scenario.TARGETS, randomTargets).with(Scenario.EVENTS, List.of());
  }

  /** Makes one step. */
  @Benchmark
  public int step() {
    simulation.step();
    return simulation.coverage().kMin();
  }
}
