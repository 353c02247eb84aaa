package org.hificamsim.network.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.core.AllocatedBytes;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;

/** Tests sums of the overlaps of pairs. */
class OverlapTableTest {
  private static World row(int count) {
    TestScenario scenario = new TestScenario();
    for (int camera = 0; camera < count; camera++) {
      scenario.camera(camera, 0);
    }
    return scenario.world();
  }

  private static double sum(OverlapTable table, World world) {
    double sum = 0;
    for (int camera = 0; camera < world.cameras().count(); camera++) {
      sum = world.cameras().online(camera) ? table.addPairs(camera, sum) : sum;
    }
    return sum;
  }

  @Test
  void countsEachOnlinePairOnce() {
    World world = row(4);
    OverlapTable table =
        new OverlapTable(world.cameras(), (first, second) -> 10 * first.x() + second.x());
    assertEquals(1 + 2 + 3 + 12 + 13 + 23, sum(table, world));
    world.switchCamera(2, false);
    assertEquals(1 + 3 + 13, sum(table, world));
  }

  @Test
  void storesEachPairOnce() {
    World world = row(1000);
    long bytes =
        AllocatedBytes.fewest(
            () -> AllocatedBytes.by(() -> new OverlapTable(world.cameras(), (first, second) -> 1)));
    assertTrue(bytes < 5_000_000, bytes + " bytes");
  }
}
