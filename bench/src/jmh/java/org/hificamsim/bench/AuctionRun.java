package org.hificamsim.bench;

import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.engine.Workers;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.StepOrder;
import org.hificamsim.core.world.World;
import org.hificamsim.network.CamSimScenario;
import org.hificamsim.network.Network;
import org.hificamsim.network.NetworkSettings;
import org.hificamsim.network.agent.ScheduleKind;

/** A run of CamSim's network as ours. */
public record AuctionRun(Simulation simulation, Network network) {
  /**
   * Starts a run with CamSim's order and visibility, and seed 0.
   *
   * @param comm the number of the communication policy: 0 is Broadcast
   */
  public static AuctionRun of(Scenario scenario, ScheduleKind schedule, int comm) {
    Catalogue catalogue = Catalogue.load();
    NetworkSettings settings = NetworkSettings.CAMSIM.withAll(schedule, comm);
    Scenario read = scenario.with(Scenario.ZOOMS, List.of()).with(Scenario.ORDER, StepOrder.CAMSIM);
    World world = new World(CamSimScenario.as(read, settings), catalogue.movements(), 0);
    Detection detection = Detection.of(catalogue.detection("camsim-visibility"));
    Network network = new Network(world, detection, settings, 0);
    Simulation simulation =
        new Simulation(
            world,
            detection,
            catalogue.policies().create("zoom-out"),
            network,
            0,
            List.of(),
            Workers.CALLER);
    return new AuctionRun(simulation, network);
  }
}
