package org.hificamsim.presentation.view;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.AimingZoomPolicy;
import org.hificamsim.core.policy.HindsightZoomPolicy;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.World;
import org.hificamsim.presentation.replay.Move;
import org.hificamsim.presentation.replay.PackedHeat;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.presentation.replay.Snapshots;
import org.hificamsim.presentation.report.ObjectiveWords;
import org.hificamsim.runs.cells.FieldCells;
import org.hificamsim.runs.heat.HeatRecorder;

/** One of the simulations of a live run, which has a choice of model and policy of its own. */
final class LiveSide {
  /**
   * Values that all simulations of a live run share.
   *
   * @param seed the seed of the world and the policies
   * @param next the step that comes next
   * @param held the view in which a camera is held, by its name; it may change between steps
   */
  record Shared(
      Catalogue catalogue,
      long seed,
      long next,
      List<Setup.Floor> floor,
      Map<String, Integer> held) {
    /**
     * Returns the pictures at the areas that a scenario gives them now, after a change of scale.
     */
    private List<Setup.Floor> floorOf(Scenario scenario) {
      return scenario
          .floorplan()
          .map(
              plan ->
                  floor.stream().map(shown -> new Setup.Floor(plan.area(), shown.data())).toList())
          .orElse(floor);
    }
  }

  private final World world;
  private final Setup setup;
  private final Snapshots snapshots;
  private final Simulation simulation;
  private final Detection detection;

  /** The recorder of the heat map; null unless a map is shown. */
  private HeatRecorder heat;

  private long firstHeatStep;
  private LiveStep.Side lastStep;

  /**
   * @param world the world as it is before the next step
   * @param policySpec the name of the policy with its options
   * @throws InputException if the policy is unknown or does not suit the scenario
   */
  LiveSide(World world, Detection detection, String policySpec, Shared shared) {
    this.world = world;
    this.detection = detection;
    ZoomPolicy policy = shared.catalogue().policies().create(policySpec);
    if (policy instanceof HindsightZoomPolicy) {
      throw InputException.of(
          "policy '%s' looks at the whole run first: it cannot be viewed live", policy.name());
    }
    if (policy instanceof AimingZoomPolicy) {
      throw InputException.of(
          "policy '%s' turns cameras to any angle: it cannot be viewed live", policySpec);
    }
    this.setup =
        Setup.of(world, detection, policySpec, shared.seed(), shared.floorOf(world.scenario()));
    this.snapshots = new Snapshots(setup, detection, policy);
    snapshots.forgetPoses(); // pages may have those of another simulation
    this.simulation =
        new Simulation(
                world,
                detection,
                HeldViews.hold(policy, shared.held()),
                shared.seed(),
                List.of(this::record))
            .continuingAt(shared.next());
  }

  /** Runs one step. */
  LiveStep.Side step() {
    simulation.step();
    return lastStep;
  }

  private void record(OracleView network, StepCoverage coverage) {
    List<Move> moves = snapshots.moves(network);
    lastStep = new LiveStep.Side(snapshots.take(network), moves, coverage.score());
    if (heat != null) {
      firstHeatStep = heat.steps() == 0 ? network.step() : firstHeatStep;
      heat.stepped(network, coverage);
    }
  }

  /** Begins a new heat map with the next step, or stops recording. */
  void recordHeat(boolean on) {
    heat = on ? new HeatRecorder(world, detection, FieldCells.DEFAULT) : null;
  }

  /** Returns the heat map; empty if none is recorded or it has no step yet. */
  Optional<PackedHeat> heat() {
    return heat == null || heat.steps() == 0
        ? Optional.empty()
        : Optional.of(PackedHeat.of(heat.map(), firstHeatStep, heat.steps()));
  }

  /** Lets the next step include the poses of all cameras, for pages that have no earlier steps. */
  void sendAllPoses() {
    snapshots.forgetPoses();
  }

  World world() {
    return world;
  }

  Setup setup() {
    return setup;
  }

  /** The objective by which a step is scored. */
  ObjectiveWords objective() {
    return ObjectiveWords.of(world.scenario().objective());
  }

  /** Returns the name of what agents estimate; empty if they estimate nothing. */
  String estimated() {
    return snapshots.estimated(simulation.network());
  }
}
