package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests {@code site}, and other commands on the scenarios that it makes. */
class SiteCommandTest {
  private static final Path SITES = Cli.ROOT.resolve("examples/plans");

  @TempDir Path folder;
  private Path out;

  @BeforeEach
  void setOutputFolder() {
    out = folder.resolve("out");
  }

  private Cli site(Path plan, Object... more) {
    List<Object> words = new ArrayList<>(List.of("site", plan, "--out", out));
    words.addAll(List.of(more));
    return Cli.run(words.toArray());
  }

  private Path write(String name, String text) throws IOException {
    return Files.writeString(folder.resolve(name), text);
  }

  private void assertMade(Cli made, String name, String line) {
    assertEquals(0, made.exit(), made.err());
    assertEquals("", made.err());
    assertTrue(made.out().contains(line), made::out);
    Cli.assertValidAndRuns(out.resolve(name + ".xml"), folder.resolve("run"));
  }

  @Test
  void makesSiteOfDxfWithBlocks() throws IOException {
    Cli made = site(SITES.resolve("room.dxf"), "--layers", "walls,COL*");
    assertMade(made, "room", "field: 16.0 x 10.0 m; walls and solids:");
    assertTrue(
        made.out().contains("left out: 2 on layers that are off or frozen, 1 text"), made::out);
    String xml = Files.readString(out.resolve("room.xml"));
    assertTrue(xml.contains("<pillar x=\"8.5\" y=\"5.0\" radius=\"0.2\"/>"), xml);
    assertTrue(xml.contains("<pillar x=\"12.5\" y=\"5.0\" radius=\"0.2\"/>"), xml);
    assertTrue(xml.contains("<!-- Made by hificamsim site of room.dxf -->"), xml);
  }

  @Test
  void makesSiteOfDrawingAtPaperScale() throws IOException {
    Cli made = site(SITES.resolve("shop.svg"), "--scale", "1:100", "--layers", "Walls,Shelves");
    assertMade(made, "shop", "field: 20.0 x 12.0 m; walls and solids: 9");
    assertTrue(made.out().contains("left out: 1 hidden, 1 text"), made::out);
  }

  @Test
  void listsLayersWithCounts() {
    Cli listed = Cli.run("site", SITES.resolve("shop.svg"), "--list-layers");
    assertEquals(0, listed.exit(), listed.err());
    assertTrue(listed.out().contains("  layer Shelves: 3\n  layer Walls: 3\n"), listed::out);
    assertTrue(listed.out().contains("  class wall: 3\n"), listed::out);
    assertTrue(listed.out().contains("  colour #a40000: 3\n"), listed::out);
    Cli dxf = Cli.run("site", SITES.resolve("room.dxf"), "--list-layers");
    assertTrue(dxf.out().contains("  layer COLUMNS: 2\n"), dxf::out);
    assertTrue(dxf.out().contains("  block SHELF: 2\n"), dxf::out);
  }

  @Test
  void rejectsBackgroundOfPageAsSolid() {
    site(SITES.resolve("shop.svg"), "--scale", "1:100")
        .assertRejected("a solid fills 100 % of the plan: it is probably the area that", out);
  }

  @ParameterizedTest
  @CsvSource({"--scale=0.05", "--width=4", "'--scale=3m=0,0:60,0'", "'--scale=300cm=0,0:0,60'"})
  void makesSiteOfPicture(String scale) throws IOException {
    Path picture = folder.resolve("Plan 1.png");
    ImageIO.write(new BufferedImage(80, 60, BufferedImage.TYPE_INT_RGB), "png", picture.toFile());
    Cli made = site(picture, scale, "--people", 2);
    assertMade(made, "Plan-1", "field: 4.0 x 3.0 m; walls and solids: 0");
    assertEquals(List.of("Plan-1-floorplan.png", "Plan-1.xml"), Cli.names(out));
    assertTrue(Files.readString(out.resolve("Plan-1.xml")).contains("Plan-1-floorplan.png"));
  }

  @Test
  void endsFieldWherePictureEnds() throws IOException {
    Path picture = folder.resolve("odd.png");
    ImageIO.write(new BufferedImage(83, 61, BufferedImage.TYPE_INT_RGB), "png", picture.toFile());
    Cli made = site(picture, "--scale=0.1", "--people", 2);
    assertMade(made, "odd", "field: 8.3 x 6.1 m; walls and solids: 0");
  }

  @Test
  void makesSiteOfMapInDegrees() throws IOException {
    Path map =
        write(
            "map.geojson",
            "{\"type\":\"LineString\",\"coordinates\":[[16,48],[16.001,48],[16.001,48.001]]}");
    assertMade(site(map), "map", "projected to metres: equirectangular, WGS84");
  }

  @Test
  void makesZonesOfWalkableAreas() throws IOException {
    Path room =
        write(
            "room.wkt",
            "GEOMETRYCOLLECTION (POLYGON ((0 0, 8 0, 8 4, 0 4, 0 0)),"
                + " POLYGON ((8 1, 12 1, 12 3, 8 3, 8 1)))");
    assertMade(site(room, "--walkable"), "room", "walls and solids: 8");
    String xml = Files.readString(out.resolve("room.xml"));
    assertEquals(2, xml.split("<zone ").length, "one zone: " + xml);
    assertTrue(xml.contains("<zone name=\"inside\" shape=\"polygon\""), xml);
  }

  @Test
  void placesCamerasOnSiteWithoutTargets() {
    Cli made = site(SITES.resolve("room.dxf"), "--cameras", 0, "--people", 0);
    assertEquals(0, made.exit(), made.err());
    Path plan = folder.resolve("plan");
    Object[] words = {
      "place", out.resolve("room.xml"), "--cameras", 2, "--cells", 12, "--candidates", "every=4"
    };
    List<Object> all = new ArrayList<>(List.of(words));
    all.addAll(List.of("--out", plan));
    Cli placed = Cli.run(all.toArray());
    assertEquals(0, placed.exit(), placed.err());
    Cli verified = Cli.run("place", "--verify", plan);
    assertEquals(0, verified.exit(), verified.err());
  }

  @Test
  void drawsSamePeopleForSameSeed() throws IOException {
    Path plan = SITES.resolve("room.dxf");
    site(plan, "--people", 3, "--seed", 5);
    String first = Files.readString(out.resolve("room.xml"));
    assertEquals(4, first.split("<object ").length);
    site(plan, "--people", 3, "--seed", 5);
    assertEquals(first, Files.readString(out.resolve("room.xml")));
  }

  @Test
  void rejectsInvalidOptionsInOneLine() throws IOException {
    Path dxf = SITES.resolve("room.dxf");
    Path svg = SITES.resolve("shop.svg");
    Path unitless = write("a.dxf", Files.readString(dxf).replace("$INSUNITS", "$OTHER"));
    site(unitless)
        .assertRejected("the drawing has no unit ($INSUNITS), expected --walls-unit", out);
    site(svg).assertRejected("expected --scale M with an SVG", out);
    site(svg, "--scale", "1:0").assertRejected("--scale is '1:0', expected the metres of", out);
    site(svg, "--scale", "2m=1,1:1,1").assertRejected("expected two points apart", out);
    site(svg, "--scale", 1, "--width", 2).assertRejected("expected one of them", out);
    site(dxf, "--layers", "WAL").assertRejected("--layers is 'WAL', which nothing", out);
    site(folder.resolve("a.png")).assertRejected("a.png: a picture without --scale M", out);
    site(folder.resolve("none.dxf")).assertRejected("none.dxf:1:1: no such file", out);
    site(dxf, "--walls-unit", "deg").assertRejected("--walls-unit is deg, expected m, cm", out);
    Path metres = write("b.geojson", "{\"type\":\"LineString\",\"coordinates\":[[0,0],[20,10]]}");
    site(metres).assertRejected("its coordinates probably have another unit, expected", out);
    Cli.run("site", dxf).assertRejected("expected --out DIR, a folder for the site", out);
  }
}
