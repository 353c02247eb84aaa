package org.hificamsim.network;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.hificamsim.core.Reference;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.movement.Movements;
import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.agent.MessageQueue;
import org.hificamsim.network.agent.NameLinks;
import org.hificamsim.network.agent.Sightings;
import org.junit.jupiter.api.Test;

/** The hash codes that order bids. */
class BidderHashesTest {
  @Test
  void theHashCodesOfPublishedCamerasAreTheKnownOnes() {
    World world =
        new World(
            ScenarioReader.read(
                Reference.file("camsim/scenarios/SASO/scenario10.xml"),
                anyMovement -> true,
                new ArrayList<>()::add),
            Movements.registry(),
            0);
    int count = world.cameras().count();
    Detection detection = Detection.of(new CamSimVisibilityDetection());
    Sightings sightings = new Sightings(world, Visibility.asInCamSim(detection));
    Agent[] agents = new Agent[count];
    ScheduleKind[] schedules = new ScheduleKind[count];
    Arrays.fill(schedules, ScheduleKind.PASSIVE);
    BidderHashes hashes = new BidderHashes(world.cameras(), sightings, agents, schedules);
    Agent.Surroundings around =
        new Agent.Surroundings(
            world.cameras(), new double[0], sightings, new MessageQueue(), hashes::of, false);
    for (int camera = 0; camera < count; camera++) {
      agents[camera] = new Agent(camera, 0, new NameLinks(0, List.of(), false), around);
      for (int other = 0; other < count; other++) {
        if (other != camera) {
          agents[camera].neighbours().add(other);
        }
      }
    }
    assertEquals(-417382511, hashes.of(0));
    assertEquals(-307410659, hashes.of(1));
  }
}
