package org.hificamsim.placement.site;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the distances at which cameras see people. */
class ViewReachTest {
  private static final double LENGTH = 40;
  private static final Catalogue CATALOGUE = Catalogue.load();

  @TempDir private Path folder;

  /**
   * Returns the reach of a camera on a site.
   *
   * @param camera attributes of the camera, whose picture is 90 degrees and 1920 pixels wide, 16:9
   * @param wall an element of the site; empty for none
   */
  private ViewReach reach(String camera, String wall, String detection) throws IOException {
    Scenario site =
        TestSite.read(
            folder,
            """
<root>
  <simulation min_x="0" max_x="50" min_y="0" max_y="50" order="coverage">
    <obstacles>%s</obstacles>
    <cameras>
      <optics name="wide" hfov="90" pixels="1920"/>
      <camera name="A" x="25" y="1" heading="0" optics="wide" %s/>
    </cameras>
    <objects><object x="5" y="5" heading="0" speed="1" features="1"/></objects>
  </simulation>
</root>
"""
                .formatted(wall, camera));
    Detection asked = Detection.of(CATALOGUE.detections().create(detection));
    Demand demand = TestSite.demand(site, Sampling.equal(10), asked);
    return new ViewReach.Axis(site.cameras().get(0), 0, LENGTH).reach(demand, asked, CATALOGUE);
  }

  @Test
  void blindZoneEndsWhereFeetEnterThePicture() throws IOException {
    double steepest = Math.toRadians(30) + Math.atan(9.0 / 16);
    assertEquals(3 / Math.tan(steepest), near("z=\"3\" tilt=\"30\""), 0.1);
    assertEquals(3 / (9.0 / 16), near("z=\"3\" tilt=\"0\""), 0.1);
  }

  private double near(String camera) throws IOException {
    return reach(camera, "", "dori-2014:level=observe").near();
  }

  @Test
  void viewsOfFlatSitesBeginAtTheCamera() throws IOException {
    assertEquals(0, near(""));
  }

  @Test
  void reachEndsWhereTooFewPixelsAreLeft() throws IOException {
    double far = 960 / 62.5;
    assertEquals(far, reach("", "", "dori-2014:level=observe").far(), 0.1);
    String wall = "<wall x1=\"0\" y1=\"8\" x2=\"50\" y2=\"8\"/>";
    assertEquals(far, reach("", wall, "dori-2014:level=observe").far(), 0.1, "walls do not count");
  }

  @Test
  void camerasThatSeeNobodyHaveNoReach() throws IOException {
    assertEquals(
        List.of(0.0, 0.0),
        List.of(
            reach("", "", "oodpcvs-2025:level=scrutinise").near(),
            reach("z=\"30\" tilt=\"0\"", "", "oodpcvs-2025:level=scrutinise").far()));
  }
}
