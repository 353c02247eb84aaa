package org.hificamsim.network;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.World;
import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.agent.MessageQueue;
import org.hificamsim.network.agent.NameLinks;
import org.hificamsim.network.agent.Sightings;
import org.junit.jupiter.api.Test;

/** The hash codes that order bids. */
class BidderHashesTest {
  @Test
  void theHashCodesOfPublishedCamerasAreTheKnownOnes() {
    World world = grid().world();
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

  /** Nine cameras of which two are those of the known hash codes (behaviour 4.5). */
  private static TestScenario grid() {
    TestScenario grid = new TestScenario().field(-20, 20, -20, 20);
    for (int i = 0; i < 9; i++) {
      grid.camera(TestScenario.camera("Cam_0" + (i + 1), -15 + 10 * i, 18, -180, 70, 16));
    }
    return grid;
  }
}
