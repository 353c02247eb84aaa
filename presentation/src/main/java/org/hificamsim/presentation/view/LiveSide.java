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
import org.hificamsim.core.world.World;
import org.hificamsim.presentation.replay.Move;
import org.hificamsim.presentation.replay.PackedHeat;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.presentation.replay.Snapshots;
import org.hificamsim.presentation.report.ObjectiveWords;
import org.hificamsim.runs.cells.FieldCells;
import org.hificamsim.runs.heat.HeatRecorder;

/** A simulation that is watched step by step: a world under one choice of model and policy. */
final class LiveSide {
  private final World world;
  private final Setup setup;
  private final Snapshots snapshots;
  private final Simulation simulation;
  private final Detection detection;
  private HeatRecorder heat;
  private long heatFrom;
  private LiveStep.Side last;

  /**
   * @param world as the steps before {@code next} have left it
   * @param seed of the world, and of the policy
   * @param policySpec name and options
   * @param next the step that comes next
   * @param held views by name of cameras that their policy does not choose, now or later
   * @throws InputException when the policy is unknown or does not suit the scenario
   */
  LiveSide(
      World world,
      Catalogue catalogue,
      Detection detection,
      String policySpec,
      long seed,
      long next,
      List<Setup.Floor> floor,
      Map<String, Integer> held) {
    this.world = world;
    this.detection = detection;
    ZoomPolicy policy = catalogue.policies().create(policySpec);
    if (policy instanceof HindsightZoomPolicy) {
      throw InputException.of(
          "policy '%s' looks at the whole run first: it cannot be viewed live", policy.name());
    }
    if (policy instanceof AimingZoomPolicy) {
      throw InputException.of(
          "policy '%s' turns cameras to any angle: it cannot be viewed live", policySpec);
    }
    this.setup = Setup.of(world, detection, policySpec, seed, floor);
    this.snapshots = new Snapshots(setup, detection, policy);
    snapshots.forgetPoses(); // pages may know them from another simulation
    this.simulation =
        new Simulation(world, detection, HeldViews.hold(policy, held), seed, List.of(this::record))
            .continuingAt(next);
  }

  /** Runs one step. */
  LiveStep.Side step() {
    simulation.step();
    return last;
  }

  private void record(OracleView network, StepCoverage coverage) {
    List<Move> moves = snapshots.moves(network);
    last = new LiveStep.Side(snapshots.take(network), moves, coverage.score());
    if (heat != null) {
      heatFrom = heat.steps() == 0 ? network.step() : heatFrom;
      heat.stepped(network, coverage);
    }
  }

  /** Begins a heat map with the next step, or makes none any more. */
  void heat(boolean on) {
    heat = on ? new HeatRecorder(world, detection, FieldCells.USUAL) : null;
  }

  /** The heat map of the steps since it was begun, if there are any. */
  Optional<PackedHeat> heat() {
    return heat == null || heat.steps() == 0
        ? Optional.empty()
        : Optional.of(PackedHeat.of(heat.map(), heatFrom, heat.steps()));
  }

  /**
   * Has the next step tell where every camera is, for those who have forgotten the steps before.
   */
  void tellPosesAgain() {
    snapshots.forgetPoses();
  }

  World world() {
    return world;
  }

  Setup setup() {
    return setup;
  }

  /** What a step is scored by. */
  ObjectiveWords objective() {
    return ObjectiveWords.of(world.scenario().objective());
  }

  /** What the agents' estimates are; empty where they have none. */
  String estimated() {
    return snapshots.estimated(simulation.network());
  }
}
