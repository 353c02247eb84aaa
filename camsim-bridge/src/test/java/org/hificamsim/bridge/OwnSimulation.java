package org.hificamsim.bridge;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.RunCoverage;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Following;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Traffic;
import org.hificamsim.runs.output.Detail;
import org.hificamsim.runs.output.SingleRun;

/** Runs CamSim's scenarios in HiFi-CamSim, whose results the bridge has to reproduce. */
final class OwnSimulation {
  static final Catalogue CATALOGUE = Catalogue.load();

  private OwnSimulation() {}

  /** Runs a scenario in CamSim's order, with seed 0, and writes its result files. */
  static RunCoverage record(
      Path folder, Path file, List<Double> zooms, Detection detection, String policy, int steps)
      throws IOException {
    return record(folder, file, zooms, detection, CATALOGUE.policies().create(policy), steps);
  }

  /** Does the same with a policy, which callers can ask for its figures afterwards. */
  static RunCoverage record(
      Path folder, Path file, List<Double> zooms, Detection detection, ZoomPolicy policy, int steps)
      throws IOException {
    return record(folder, scenario(file, zooms), detection, policy, steps);
  }

  /** Does the same for a scenario that has been read already. */
  static RunCoverage record(
      Path folder, Scenario scenario, Detection detection, ZoomPolicy policy, int steps)
      throws IOException {
    World world = new World(scenario, CATALOGUE.movements(), 0);
    RunCoverage coverage = new RunCoverage();
    try (SingleRun run =
        new SingleRun(folder, 0, detection, Detail.full(scenario), Following.TARGETS)) {
      new Simulation(world, detection, policy, 0, List.of(coverage, run)).run(steps);
      RunPlan plan = new RunPlan(world.scenario(), detection, "own", steps, 0, 1);
      run.commit(plan, Traffic.NONE, Optional.empty());
    }
    return coverage;
  }

  /** Returns the detection by a model at its default threshold. */
  static Detection detection(String name) {
    return Detection.of(CATALOGUE.detection(name));
  }

  /**
   * Reads a scenario, and gives all its cameras, including those that events add, the same optics,
   * each with its range as the reach.
   */
  static Scenario scenario(Path file, OpticsSpec optics) {
    return scenario(file, List.of()).withCameras(camera -> with(camera, optics));
  }

  /** Returns a camera with optics whose reach is its range; CamSim turns 20 m or more into 16 m. */
  private static CameraSpec with(CameraSpec camera, OpticsSpec optics) {
    double reach = camera.range() >= 20 ? 16 : camera.range();
    return camera.with(CameraSpec.OPTICS, optics.with(OpticsSpec.REACH, reach));
  }

  static Scenario scenario(Path file, List<Double> zooms) {
    return ScenarioReader.read(file, name -> true, warning -> {})
        .with(Scenario.ORDER, StepOrder.CAMSIM)
        .with(Scenario.ZOOMS, zooms);
  }
}
