package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.Texts;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.placement.site.PriceList;
import org.hificamsim.placement.site.SitePlanner;
import org.hificamsim.presentation.view.Planner;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that a plan's claims about zones hold for their area and agree among commands. */
class ZoneClaimTest {
  private static final Catalogue CATALOGUE = Catalogue.load();

  @TempDir private Path folder;
  private Path plan;
  private Map<String, Double> claimed;

  @BeforeEach
  void placeInShop() throws IOException {
    Path shop =
        Files.writeString(
            folder.resolve("shop.xml"),
            """
<root>
  <simulation min_x="0" max_x="20" min_y="0" max_y="12" order="coverage"
      mount_height="3" detection="oodpcvs-2025:level=perceive" steps="4">
    <obstacles>
      <polygon points="5,3.5 5.8,3.5 5.8,9.5 5,9.5" height="1.8"/>
      <polygon points="8,3.5 8.8,3.5 8.8,9.5 8,9.5" height="1.8"/>
    </obstacles>
    <zones>
      <zone name="door" points="16.5,0.3 19.6,2.4"
          detection="oodpcvs-2025:level=characterise"
          facing="0" facing_tolerance="7" max_depression="15"/>
      <zone name="aisle" points="5.9,3.5 7.9,9.5" k="2"/>
    </zones>
    <cameras><camera name="A" x="1" y="1" heading="45" viewing_angle="70" range="9"/></cameras>
    <objects>
      <object features="1" x="17" y="3" heading="0" speed="1"
          width="0.5" height="1.75"/>
    </objects>
  </simulation>
</root>
""");
    plan = folder.resolve("plan");
    Cli placed = Cli.run("place", shop, "--cameras", 3, "--candidates", "every=3", "--out", plan);
    assertEquals(0, placed.exit(), placed.err());
    claimed = ZoneRaster.claims(placed.out());
    assertEquals(List.of("aisle", "door"), claimed.keySet().stream().sorted().toList());
    assertTrue(
        claimed.values().stream().anyMatch(share -> share > 1 && share < 99.9), placed.out());
  }

  @Test
  void claimHoldsOnFineRasterOfPeople() {
    Scenario planned = read();
    for (Zone zone : planned.zones()) {
      assertEquals(
          100 * ZoneRaster.share(planned, zone, "oodpcvs-2025:level=perceive"),
          claimed.get(zone.name()),
          1,
          zone.name());
    }
  }

  @Test
  void allCommandsReportSameSharesOfZones() throws IOException {
    Cli verified = Cli.run("place", "--verify", plan);
    assertEquals(0, verified.exit(), verified.err());
    assertEquals(claimed, ZoneRaster.claims(verified.out()));

    Path out = folder.resolve("run");
    Cli run = Cli.run("run", plan.resolve("plan.xml"), "--policy", "fixed:0", "--out", out);
    assertEquals(0, run.exit(), run.err());
    JsonNode metrics = new ObjectMapper().readTree(out.resolve("summary.json").toFile());
    double least = claimed.values().stream().mapToDouble(share -> share).min().orElseThrow();
    assertEquals(least, 100 * metrics.findValue("least_zone_met").asDouble(), 0.01);
    for (JsonNode zone : metrics.path("zones")) {
      double claim = claimed.get(zone.path("name").asText());
      assertEquals(claim, 100 * zone.path("met").asDouble(), 0.01, zone + "");
      String line = Texts.format("zone %-11s %.2f %%", zone.path("name").asText(), claim);
      assertTrue(run.out().contains(line), run.out());
    }
    assertEquals(2, metrics.path("zones").size());

    Path compared = folder.resolve("compared");
    Cli comparison =
        Cli.run(
            "compare",
            plan.resolve("plan.xml"),
            "--policies",
            "fixed:0,zoom-out",
            "--repeat",
            1,
            "--out",
            compared);
    assertEquals(0, comparison.exit(), comparison.err());
    List<String> rows =
        Files.readAllLines(compared.resolve("metrics.csv")).stream()
            .filter(row -> row.contains(",least_zone_met,") && row.contains(",fixed:0,"))
            .toList();
    assertEquals(1, rows.size(), () -> Cli.text(compared.resolve("metrics.csv")));
    String value = rows.get(0).substring(rows.get(0).lastIndexOf(',') + 1);
    assertEquals(least, 100 * Double.parseDouble(value), 0.01);

    List<Planner.Share> shown =
        new SitePlanner(
                CATALOGUE, ZoneRaster::detection, PriceList.named(PriceList.GENERIC, read()))
            .shares(read(), ZoneRaster.detection("oodpcvs-2025:level=perceive"));
    for (Planner.Share share : shown) {
      assertEquals(claimed.get(share.zone()), 100 * share.met(), 0.01, share.zone());
    }
  }

  /**
   * The camera at 3 m has a picture that ends 48.0 degrees below the horizon. It sees the top of a
   * person of 1.75 m beyond a distance of 1.13 m, and the chin (at 1.517 m) beyond 1.34 m.
   */
  @ParameterizedTest
  @CsvSource({"'', 75", "'facing=\"180\" facing_tolerance=\"89\"', 33"})
  void countsFaceOnlyWithChinInPicture(String faces, double share) throws IOException {
    Path site =
        Files.writeString(
            folder.resolve("chin.xml"),
            """
<root>
  <simulation min_x="0" max_x="20" min_y="0" max_y="12" order="coverage" mount_height="3"
      detection="oodpcvs-2025:level=characterise" steps="1">
    <zones><zone name="strip" points="9.9,1 10.1,1.5" %s/></zones>
    <cameras>
      <optics name="o" law="pinhole" pixels="1920" hfov="60" aspect="1.7777778"/>
      <camera name="A" x="10" y="0" heading="0" tilt="30" optics="o"/>
    </cameras>
    <objects>
      <object features="1" x="17" y="3" heading="0" speed="1" width="0.5" height="1.75"/>
    </objects>
  </simulation>
</root>
"""
                .formatted(faces));
    Cli cli = Cli.run("place", "--evaluate", site);
    assertEquals(0, cli.exit(), cli.err());
    assertEquals(share, ZoneRaster.claims(cli.out()).get("strip"), 1.5, cli.out());
  }

  @Test
  void planOpensWithItsFloorplan() throws IOException {
    Path picture = Files.createDirectories(folder.resolve("pictures")).resolve("floor.png");
    ImageIO.write(new BufferedImage(40, 24, BufferedImage.TYPE_INT_RGB), "png", picture.toFile());
    Path shop = folder.resolve("shop.xml");
    Files.writeString(
        shop,
        Files.readString(shop)
            .replace(" mount_height", " floorplan=\"pictures/floor.png\" mount_height"));
    Path drawn = folder.resolve("drawn");
    Cli placed = Cli.run("place", shop, "--cameras", 1, "--candidates", "every=6", "--out", drawn);
    assertEquals(0, placed.exit(), placed.err());
    assertEquals(-1, Files.mismatch(picture, drawn.resolve("floor.png")));
    Path out = folder.resolve("recorded");
    Cli run = Cli.run("run", drawn.resolve("plan.xml"), "--record", "--out", out);
    assertEquals(0, run.exit(), run.err());
    String camera = Files.readAllLines(drawn.resolve("cameras.csv")).get(1);
    assertEquals("3.0", camera.split(",")[4], camera);
  }

  @Test
  void findsFacesThatPlanWithoutFacingMisses() throws IOException {
    Path unasked = folder.resolve("unasked.xml");
    String shop = Files.readString(folder.resolve("shop.xml"));
    Files.writeString(
        unasked, shop.replaceAll("facing=\"0\" facing_tolerance=\"7\" max_depression=\"15\"", ""));
    Path other = folder.resolve("other");
    Cli placed =
        Cli.run("place", unasked, "--cameras", 3, "--candidates", "every=3", "--out", other);
    assertEquals(0, placed.exit(), placed.err());
    Path asked = other.resolve("asked.xml");
    Files.writeString(
        asked,
        Files.readString(other.resolve("plan.xml"))
            .replace("name=\"door\"", "name=\"door\" facing=\"0\" max_depression=\"20\""));
    double faces = ZoneRaster.claims(Cli.run("place", "--evaluate", asked).out()).get("door");
    assertTrue(
        faces < 50 && ZoneRaster.claims(placed.out()).get("door") > 90, faces + placed.out());
  }

  @ParameterizedTest
  @CsvSource({
    "facing=\"400\", expected degrees from -360 to 360",
    "facing=\"0\" facing_tolerance=\"0\", expected degrees above 0 and at most 180",
    "facing_tolerance=\"9\", 'has a facing_tolerance, expected facing, too'",
    "max_depression=\"91\", expected degrees above 0 and at most 90"
  })
  void rejectsInvalidAttributesOfFaces(String attributes, String message) throws IOException {
    assertRejected(
        "facing=\"0\" facing_tolerance=\"7\" max_depression=\"15\"", attributes, message);
  }

  @Test
  void rejectsDepressionInFlatWorld() throws IOException {
    assertRejected(" height=\"1.8\"", "", "max_depression is '15', expected none in a flat world");
  }

  @Test
  void validateRejectsUnknownLevelOfZone() throws IOException {
    assertRejected(
        "=characterise", "=recognize", "zone 'door': detection oodpcvs-2025: level is 'recognize'");
  }

  /** Replaces a text of the shop, and asserts that validation fails with a message. */
  private void assertRejected(String text, String changed, String message) throws IOException {
    Path shop = folder.resolve("shop.xml");
    Files.writeString(shop, Files.readString(shop).replace(text, changed));
    Cli validated = Cli.run("validate", shop);
    assertEquals(2, validated.exit());
    assertTrue(validated.err().contains(message), validated.err());
  }

  private Scenario read() {
    return ScenarioReader.read(plan.resolve("plan.xml"), name -> true, warning -> {});
  }
}
