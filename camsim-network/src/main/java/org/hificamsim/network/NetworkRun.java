package org.hificamsim.network;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Behaviour;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.World;
import org.hificamsim.network.statistics.StepFigures;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Traffic;

/**
 * A run of CamSim's network, from a plan to what it adds up to; files are written by those who
 * listen. Runs share nothing, so that any number of them may go on side by side.
 */
public final class NetworkRun {
  private final World world;
  private final Network network;
  private final Detection detection;
  private final ZoomPolicy policy;
  private final long seed;
  private final List<StepListener> listeners = new ArrayList<>();
  private Simulation simulation;

  /**
   * A run before its first step.
   *
   * @param policy zooms the cameras
   * @param seed of all random streams
   * @throws org.hificamsim.core.InputException when a camera asks for what does not exist
   */
  public NetworkRun(
      Scenario scenario,
      Detection detection,
      ZoomPolicy policy,
      Registry<Movement> movements,
      NetworkSettings settings,
      long seed) {
    this.detection = detection;
    this.policy = policy;
    this.seed = seed;
    world = new World(scenario, movements, seed);
    network = new Network(world, detection, settings, seed);
  }

  /** The first run of a plan. */
  public static NetworkRun of(RunPlan plan, NetworkSettings settings, Catalogue catalogue) {
    ZoomPolicy policy = catalogue.policies().create(plan.policy());
    return new NetworkRun(
        plan.scenario(), plan.detection(), policy, catalogue.movements(), settings, plan.seed());
  }

  /** Has the steps watched, from the first one on. */
  public NetworkRun listen(StepListener listener) {
    listeners.add(listener);
    return this;
  }

  /** The world. */
  public World world() {
    return world;
  }

  /** The network. */
  public Network network() {
    return network;
  }

  /** What the steps so far add up to. */
  public StepFigures sums() {
    return network.total();
  }

  /** What the cameras sent: of messages StartSearch alone, as CamSim counts; the bits of all. */
  public Traffic traffic() {
    long bits = network.bits() + policy.bits();
    return new Traffic(sums().communication(), bits, 0).over(simulation().network().channel());
  }

  /** The loop over the steps; who is to watch them has been named before. */
  public Simulation simulation() {
    if (simulation == null) {
      simulation =
          new Simulation(world, detection, new Behaviour(policy, network), seed, listeners);
    }
    return simulation;
  }

  /** Runs this many steps; returns what they add up to. */
  public StepFigures run(long steps) {
    simulation().run(steps);
    return sums();
  }
}
