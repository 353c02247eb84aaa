package org.hificamsim.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.List;
import java.util.Random;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.World;
import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.agent.AuctionSchedule;
import org.hificamsim.network.agent.BidderHashes;
import org.hificamsim.network.agent.CommunicationPolicy;
import org.hificamsim.network.agent.HistoricalParameters;
import org.hificamsim.network.agent.Links;
import org.hificamsim.network.agent.MessageQueue;
import org.hificamsim.network.agent.ScheduleKind;
import org.hificamsim.network.agent.Searches;
import org.hificamsim.network.agent.Sightings;
import org.hificamsim.network.agent.TargetKeys;
import org.junit.jupiter.api.Test;

/** Tests the hash codes that order bids. */
class BidderHashesTest {
  private static final int FIRST = -417382511;

  @Test
  void hashCodesOfPublishedCamerasEqualRecording() {
    BidderHashes hashes = hashes(grid().world());
    assertEquals(FIRST, hashes.hash(0));
    assertEquals(-307410659, hashes.hash(1));
  }

  @Test
  void hashCodeFollowsZoomAndPose() {
    World world = grid().zooms(4, 16).world();
    BidderHashes kept = hashes(world);
    assertEquals(FIRST, kept.hash(0));
    world.cameras().turnTo(0, 0);
    assertNotEquals(FIRST, kept.hash(0));
    assertEquals(hashes(world).hash(0), kept.hash(0));
    world.cameras().aim(0, 1, 0.5);
    assertNotEquals(FIRST, kept.hash(0));
    assertEquals(hashes(world).hash(0), kept.hash(0));
    world.cameras().turnTo(0, 1);
    assertEquals(FIRST, kept.hash(0));
  }

  /** Creates the hash codes of passive cameras that are all neighbours. */
  private static BidderHashes hashes(World world) {
    int count = world.cameras().count();
    Detection detection = Detection.of(new CamSimVisibilityDetection());
    Sightings sightings = new Sightings(world, Visibility.asInCamSim(detection, 0));
    Agent[] agents = new Agent[count];
    BidderHashes hashes = new BidderHashes(world.cameras(), sightings, agents);
    Agent.Shared shared =
        new Agent.Shared(
            world.cameras(),
            new TargetKeys(new double[0]),
            sightings,
            new Searches(world.cameras(), world.targets().count()),
            new MessageQueue(4, 8),
            new Random(0),
            hashes::hash,
            false);
    for (int camera = 0; camera < count; camera++) {
      agents[camera] = passive(camera, world, shared);
      for (int other = 0; other < count; other++) {
        if (other != camera) {
          agents[camera].addNeighbour(other);
        }
      }
    }
    return hashes;
  }

  /** Returns a scenario of nine cameras, two of which have published hash codes (behaviour 4.5). */
  private static TestScenario grid() {
    TestScenario grid = new TestScenario().field(-20, 20, -20, 20);
    for (int i = 0; i < 9; i++) {
      grid.camera(TestScenario.camera("Cam_0" + (i + 1), -15 + 10 * i, 18, -180, 70, 16));
    }
    return grid;
  }

  private static Agent passive(int camera, World world, Agent.Shared shared) {
    AuctionSchedule schedule =
        new AuctionSchedule(ScheduleKind.PASSIVE, world.targets(), HistoricalParameters.DEFAULT);
    Links links = Links.plain(0, List.of(), false);
    return new Agent(camera, 0, schedule, CommunicationPolicy.BROADCAST, links, shared);
  }
}
