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
 * A run of CamSim's network, from a plan to its sums. Listeners write the files. Runs share
 * nothing, so any number of them may run in parallel.
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
   * Prepares a run before its first step.
   *
   * @param policy chooses the views of the cameras
   * @param seed the seed of all random streams
   * @throws org.hificamsim.core.InputException if a camera names a schedule, policy or bandit that
   *     does not exist
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

  /** Returns the first run of a plan. */
  public static NetworkRun of(RunPlan plan, NetworkSettings settings, Catalogue catalogue) {
    ZoomPolicy policy = catalogue.policies().create(plan.policy());
    return new NetworkRun(
        plan.scenario(), plan.detection(), policy, catalogue.movements(), settings, plan.seed());
  }

  /** Adds a listener; call it before the first step. */
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

  /** The sums over all steps so far. */
  public StepFigures sums() {
    return network.total();
  }

  /**
   * The traffic so far: StartSearch messages, as CamSim counts them, and the bits of all messages.
   */
  public Traffic traffic() {
    long bits = network.bits() + policy.bits();
    return new Traffic(sums().communication(), bits, 0).over(simulation().network().channel());
  }

  /** The simulation of the run; its listeners are those added before the first call. */
  public Simulation simulation() {
    if (simulation == null) {
      simulation =
          new Simulation(world, detection, new Behaviour(policy, network), seed, listeners);
    }
    return simulation;
  }

  /** Runs a number of steps and returns the sums over all steps so far. */
  public StepFigures run(long steps) {
    simulation().run(steps);
    return sums();
  }
}
