package org.hificamsim.network.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.core.AllocatedBytes;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;

/** Overlaps of pairs, added up. */
class OverlapTableTest {
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
    OverlapTable table =
        new OverlapTable(world.cameras(), (first, second) -> 10 * first.x() + second.x());
    assertEquals(1 + 2 + 3 + 12 + 13 + 23, table.sum());
    world.switchCamera(2, false);
    assertEquals(1 + 3 + 13, table.sum());
  }

  @Test
  void aTableHasRoomForEachPairOnce() {
    World world = row(1000);
    long bytes =
        AllocatedBytes.fewest(() -> AllocatedBytes.by(() -> OverlapTable.exact(world.cameras())));
    assertTrue(bytes < 5_000_000, bytes + " bytes");
  }
}
