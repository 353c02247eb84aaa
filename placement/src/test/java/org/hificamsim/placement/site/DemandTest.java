package org.hificamsim.placement.site;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.placement.site.Demand.ZoneDemand;
import org.hificamsim.runs.cells.FieldCells;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class DemandTest {
  @TempDir private Path folder;

  private Demand demand(Sampling sampling) throws IOException {
    Scenario site =
        TestSite.read(
            folder,
            """
<root>
  <simulation min_x="0" max_x="20" min_y="0" max_y="12" order="coverage">
    <obstacles><polygon points="5,3 5.8,3 5.8,9 5,9"/></obstacles>
    <zones><zone name="till" points="10,2 12,3"/><zone name="all" shape="field"/></zones>
    <cameras><camera name="A" x="1" y="1" heading="0" viewing_angle="60" range="9"/></cameras>
    <objects><object x="2" y="2" heading="0" speed="1" features="1"/></objects>
  </simulation>
</root>
""");
    Detection detection = Detection.of(Catalogue.load().detections().create("geometric"));
    return TestSite.demand(site, sampling, detection);
  }

  @Test
  void smallZonesGetSmallCells() throws IOException {
    Demand demand = demand(Sampling.BY_ZONE);
    ZoneDemand till = demand.zones().get(0);
    ZoneDemand all = demand.zones().get(1);
    assertTrue(till.count() >= 90 && till.count() <= 110, "" + till.count());
    assertEquals(20.0 / 60, demand.cells(all).width(), 1e-9);
    assertTrue(all.count() < 2400, "" + all.count());
  }

  @Test
  void weightsOfZonesAreProportionalToAreas() throws IOException {
    for (Sampling sampling : new Sampling[] {Sampling.BY_ZONE, Sampling.equal(100)}) {
      Demand demand = demand(sampling);
      double till = demand.weight(demand.zones().get(0));
      double all = demand.weight(demand.zones().get(1));
      assertEquals((20 * 12 - 0.8 * 6) / 2, all / till, 6);
    }
  }

  @Test
  void smallestCellsBesideObstaclesHavePoints() throws IOException {
    Demand demand = demand(Sampling.BY_ZONE);
    FieldCells finest = demand.finestCells();
    int[] points = demand.pointsByCell(demand.zones().get(1), finest);
    for (double y = 3.05; y < 9; y += 0.1) {
      assertTrue(
          points[finest.cellAt(4.95, y)] >= 0 && points[finest.cellAt(5.85, y)] >= 0, "" + y);
    }
    int[] pointsOfTill = demand.pointsByCell(demand.zones().get(0), finest);
    assertEquals(-1, pointsOfTill[finest.cellAt(5, 1)]);
  }
}
