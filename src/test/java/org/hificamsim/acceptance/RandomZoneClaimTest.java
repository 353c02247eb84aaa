package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Random;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.Zone;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that the claims of {@code place --evaluate} about zones hold on random sites. */
class RandomZoneClaimTest {
  private static final double TOLERANCE = 1;

  @TempDir private Path folder;

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
  void claimHoldsOnRandomSites(int seed) throws IOException {
    Path site = Files.writeString(folder.resolve("random.xml"), randomSite(new Random(seed)));
    Cli evaluated = Cli.run("place", "--evaluate", site);
    assertEquals(0, evaluated.exit(), evaluated.err());
    Scenario planned = ScenarioReader.read(site, name -> true, warning -> {});
    Map<String, Double> claims = ZoneRaster.claims(evaluated.out());
    for (Zone zone : planned.zones()) {
      double share = 100 * ZoneRaster.share(planned, zone, "oodpcvs-2025:level=perceive");
      assertEquals(share, claims.get(zone.name()), TOLERANCE, zone.name());
    }
  }

  private static String randomSite(Random random) {
    StringBuilder shelves = new StringBuilder();
    for (int shelf = 0; shelf < 3; shelf++) {
      double x = random.nextDouble(2, 17);
      double y = random.nextDouble(2, 7);
      shelves.append(
          "<polygon points=\"%s,%s %s,%s %s,%s %s,%s\" height=\"1.8\"/>"
              .formatted(x, y, x + 0.8, y, x + 0.8, y + 3, x, y + 3));
    }
    StringBuilder cameras = new StringBuilder();
    for (int camera = 0; camera < 4; camera++) {
      cameras.append(
          "<camera name=\"C%s\" x=\"%s\" y=\"%s\" heading=\"%s\" tilt=\"15\" optics=\"o\"/>"
              .formatted(
                  camera,
                  random.nextDouble(0, 20),
                  camera % 2 == 0 ? 0.1 : 11.9,
                  random.nextDouble(-50, 50) + (camera % 2 == 0 ? 0 : 180)));
    }
    return """
<root>
  <simulation min_x="0" max_x="20" min_y="0" max_y="12" order="coverage"
      mount_height="3" detection="oodpcvs-2025:level=perceive" steps="1">
    <obstacles>%s<pillar x="%s" y="1.2" radius="0.3"/></obstacles>
    <zones>
      <zone name="faces" %s k="1" facing="%s" facing_tolerance="50" max_depression="25"/>
      <zone name="twice" %s k="2"/>
    </zones>
    <cameras><optics name="o" law="pinhole" pixels="1920" hfov="70"/>%s</cameras>
    <objects>
      <object features="1" x="1" y="1.5" heading="0" speed="0" width="0.5" height="1.75"/>
    </objects>
  </simulation>
</root>
"""
        .formatted(
            shelves,
            random.nextDouble(2, 18),
            randomRectangle(random),
            random.nextInt(360) - 180,
            randomRectangle(random),
            cameras);
  }

  private static String randomRectangle(Random random) {
    double x = random.nextDouble(1, 16);
    double y = random.nextDouble(1, 9);
    return "points=\"%s,%s %s,%s\"".formatted(x, y, x + 2.5, y + 2);
  }
}
