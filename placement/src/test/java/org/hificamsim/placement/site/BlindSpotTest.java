package org.hificamsim.placement.site;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.runs.cells.FieldCells;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BlindSpotTest {
  @TempDir private Path folder;

  @Test
  void joinsCellsThatTouchAndCountsPartsOfCells() {
    FieldCells cells = FieldCells.of(new Field(0, 8, 0, 6), 4); // 4 x 3 cells of 2 m
    double[] missing = {1, 0, 0, .5, 0, 1, 0, 0, 0, 0, 0, 1};
    List<BlindSpot> spots = BlindSpot.of("till", cells, missing);
    assertEquals(
        List.of(
            new BlindSpot("till", 8, 2, 2),
            new BlindSpot("till", 4, 7, 5),
            new BlindSpot("till", 2, 7, 1)),
        spots,
        "the first is joined at a corner; the end of a row and the next row are apart");
    assertEquals(spots.subList(0, 2), BlindSpot.Listing.of(spots, 2).shown());
    assertEquals(1, BlindSpot.Listing.of(spots, 2).others());
    List<BlindSpot> slivers = List.of(new BlindSpot("till", 0.04, 1, 1));
    assertEquals(new BlindSpot.Listing(List.of(), 1, 0.04), BlindSpot.Listing.of(slivers, 2));
  }

  @Test
  void areasSumToAreaThatIsNotMet() throws IOException {
    Scenario site =
        TestSite.read(
            folder,
            """
<root>
  <simulation min_x="0" max_x="20" min_y="0" max_y="12" order="coverage">
    <obstacles><polygon points="5,3 5.8,3 5.8,9 5,9"/></obstacles>
    <zones><zone name="till" points="2,2 6,4" k="2"/><zone name="all" points="1,1 15,10"/></zones>
    <cameras>
      <camera name="A" x="1" y="1" heading="45" viewing_angle="60" range="9"/>
      <camera name="B" x="1" y="11" heading="135" viewing_angle="60" range="9"/>
    </cameras>
    <objects><object x="2" y="2" heading="0" speed="1" features="1"/></objects>
  </simulation>
</root>
""");
    Catalogue catalogue = Catalogue.load();
    Detection asked = Detection.of(catalogue.detections().create("geometric"));
    Demand demand = TestSite.demand(site, Sampling.equal(30), asked);
    PlanCover cover =
        PlanCover.of(
            demand, new PointSight(demand, catalogue), site.cameras(), CoverageReading.FIXED);
    for (int zone = 0; zone < 2; zone++) {
      PlanArea.MeasuredZone measured = cover.area().zones().get(zone);
      String name = demand.zones().get(zone).name();
      double blind =
          cover.blindSpots().stream()
              .filter(spot -> spot.zone().equals(name))
              .mapToDouble(BlindSpot::area)
              .sum();
      assertTrue(measured.share() > 0.1 && measured.share() < 0.9, name);
      assertEquals((1 - measured.share()) * measured.squareMetres(), blind, 1e-9, name);
    }
  }
}
