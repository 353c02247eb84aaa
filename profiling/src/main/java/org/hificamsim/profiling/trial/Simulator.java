package org.hificamsim.profiling.trial;

import java.util.List;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.movement.Movements;

/** One step of the simulation itself, of cameras that stay as they are. */
final class Simulator {
  private static final Registry<Movement> MOVEMENTS =
      Movements.register(new Registry<>("movement"));

  private Simulator() {}

  /** How the scenario's targets are covered. */
  static StepCoverage coverage(Scenario scenario, Detection detection) {
    World world = new World(scenario, MOVEMENTS, 0);
    Simulation simulation = new Simulation(world, detection, new Still(), 0, List.of());
    simulation.run(1);
    return simulation.coverage();
  }

  private static final class Still implements ZoomPolicy {
    @Override
    public String name() {
      return "still";
    }

    @Override
    public void decide(NetworkView network, int[] views) {}
  }
}
