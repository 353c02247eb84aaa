package org.hificamsim.network.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.core.AllocatedBytes;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;

/** Overlaps of pairs, added up. */
class OverlapTableTest {
  private static final double RANGE = 5; // of the cameras

  private static World row(int count) {
    TestScenario scenario = new TestScenario();
    for (int camera = 0; camera < count; camera++) {
      scenario.camera(camera, 0);
    }
    return scenario.world();
  }

  @Test
  void eachPairThatIsOnlineCountsOnce() {
    World world = row(4);
    OverlapTable table = new OverlapTable(world.cameras(), world.scenario().field());
    double beside = overlap(1);
    double apart = overlap(2);
    assertTrue(beside > apart && apart > 0);
    assertEquals(beside, table.addPairs(2, 0), 1e-9);
    assertEquals(2 * beside + apart, table.addPairs(1, beside), 1e-9);
    world.switchCamera(2, false);
    assertEquals(apart, table.addPairs(1, 0), 1e-9);
  }

  private static double overlap(double apart) {
    return CamSimOverlap.of(0, 0, RANGE, apart, 0, RANGE);
  }

  @Test
  void aTableHasRoomForEachPairOnce() {
    World world = row(1000);
    long bytes =
        AllocatedBytes.fewest(
            () ->
                AllocatedBytes.by(
                    () -> new OverlapTable(world.cameras(), world.scenario().field())));
    assertTrue(bytes < 5_000_000, bytes + " bytes");
  }
}
