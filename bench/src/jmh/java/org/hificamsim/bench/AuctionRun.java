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

/** A run of CamSim's network as ours: schedule Passive, policy Broadcast. */
public record AuctionRun(Simulation simulation, Network network) {
  private static final NetworkSettings SETTINGS =
      NetworkSettings.CAMSIM.withAll(ScheduleKind.PASSIVE, 0);

  /** Starts a run with CamSim's order and visibility, and seed 0. */
  public static AuctionRun of(Scenario scenario) {
    Catalogue catalogue = Catalogue.load();
    Scenario read = scenario.withoutZooms().withOrder(StepOrder.CAMSIM);
    World world = new World(CamSimScenario.as(read, SETTINGS), catalogue.movements(), 0);
    Detection detection = Detection.of(catalogue.detection("camsim-visibility"));
    Network network = new Network(world, detection, SETTINGS, 0);
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
