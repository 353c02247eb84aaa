package org.hificamsim.tracks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.LocalProjection;
import org.hificamsim.tracks.place.Drawing;
import org.hificamsim.tracks.place.DrawingSettings;
import org.hificamsim.tracks.place.LayerChoice;
import org.hificamsim.tracks.place.PictureFrame;
import org.hificamsim.tracks.place.PlanScale;
import org.hificamsim.tracks.place.WallFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests walls that can be read only in part. */
class OddWallsTest {
  @TempDir Path folder;

  private Drawing drawing(String name, String text, String... layers) {
    try {
      return WallFile.read(
          Files.writeString(folder.resolve(name), text),
          new DrawingSettings(
              Optional.empty(),
              Unit.M,
              new LocalProjection(),
              Optional.of(new PictureFrame(new PlanScale.PerUnit(1), 0, 0)),
              new LayerChoice(List.of(layers))));
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void leavesOutCurvesOfWellKnownText() {
    Drawing drawing =
        drawing(
            "a.wkt",
            """
            CURVEPOLYGON (CIRCULARSTRING (0 0, 4 0, 4 4, 0 4, 0 0))
            LINESTRING EMPTY LINESTRING (0 0, 10 0)
            COMPOUNDCURVE Z (CIRCULARSTRING (0 0 1, 1 1 1, 1 0 1), (1 0 1, 0 1 1))
            TIN (((0 0, 0 9, 9 0, 0 0))) GEOMETRYCOLLECTION (CIRCULARSTRING (0 0, 1 1, 2 0))
            SRID=25832;POLYGON ((5 5, 6 5, 6 6, 5 5))
            """);
    assertEquals(
        Optional.of("left out: 1 circularstring, 1 compoundcurve, 1 curvepolygon, 1 tin"),
        drawing.leftOut());
    assertEquals(2, drawing.obstacles(false).size());
  }

  @Test
  void readsTablesOfWellKnownText() {
    Drawing drawing =
        drawing(
            "walls.csv",
            """
            id;WKT;height;kind
            1;"LINESTRING (0 0, 10 0)";2,5;outer
            2;"POLYGON ((5 5, 6 5, 6 6, 5 5))";;pillar
            3;;3;none
            """);
    List<Obstacle> walls = drawing.obstacles(false);
    assertEquals(new Obstacle.Wall(0, 0, 10, 0, 0, 0, 2.5), walls.get(0));
    assertTrue(walls.get(1) instanceof Obstacle.Polygon, walls::toString);
    assertEquals(Optional.of("left out: 1 row without a geometry"), drawing.leftOut());
    String table =
        "kind,geometry\nouter,\"LINESTRING (0 0, 1 0)\"\ninner,\"LINESTRING (0 0, 2 0)\"\n";
    assertEquals(1, drawing("b.csv", table, "kind=inner").obstacles(false).size());
    assertRejected("c.csv", "a,b\n1,2\n", "c.csv:1:1: the columns are a, b, expected wkt or");
    assertRejected("d.csv", "wkt\nLINES 5\n", "d.csv:2:1: Unknown geometry type");
  }

  @Test
  void leavesOutOddHeights() {
    String wall =
        "{\"type\": \"Feature\", \"properties\": {\"height\": %s}, \"geometry\": {\"type\":"
            + " \"LineString\", \"coordinates\": [[1, %s], [3, 4]]}}";
    String features =
        String.join(
            ",",
            wall.formatted("\"2,5\"", 1),
            wall.formatted("\"~10\"", 2),
            wall.formatted("-3", 3),
            wall.formatted("[1]", 4));
    Drawing drawing =
        drawing("a.geojson", "{\"type\": \"FeatureCollection\", \"features\": [" + features + "]}");
    List<Obstacle> walls = drawing.obstacles(false);
    assertEquals(new Obstacle.Wall(1, 1, 3, 4, 0, 0, 2.5), walls.get(0));
    assertEquals(new Obstacle.Wall(1, 2, 3, 4, 0), walls.get(1));
    assertEquals(4, walls.size());
    String leftOut = drawing.leftOut().orElseThrow();
    assertTrue(leftOut.startsWith("left out: 3 height; the first height: "), leftOut);
    assertTrue(leftOut.contains("height is '~10', expected a height such as 12"), leftOut);
    assertTrue(
        drawing("b.wkt", "LINESTRING Z (1 2 3, 4 5 6)").leftOut().orElseThrow().contains("Z is 3"));
  }

  @Test
  void reportsChosenLayersThatAreHidden() {
    String dxf =
        ("0 SECTION 2 HEADER 9 $INSUNITS 70 6 0 ENDSEC 0 SECTION 2 TABLES 0 LAYER 2 Cold 70 1 62 7"
                + " 0 ENDSEC 0 SECTION 2 ENTITIES 0 LINE 8 Cold 10 0 20 0 11 4 21 0"
                + " 0 LINE 8 Warm 10 0 20 0 11 4 21 0 0 ENDSEC 0 EOF")
            .replace(' ', '\n');
    assertRejected("a.dxf", dxf, "layers is 'COLD', which is hidden, off or frozen", "COLD");
    String svg =
        "<svg height='9'><g id='old' style='display:none'><path d='M0,0 h5'/></g>"
            + "<path id='new' d='M0,0 h5'/></svg>";
    assertRejected("a.svg", svg, "layers is 'old', which is hidden, off or frozen", "old");
  }

  private void assertRejected(String name, String text, String message, String... layers) {
    InputException error =
        assertThrows(InputException.class, () -> drawing(name, text, layers).obstacles(false));
    assertTrue(error.getMessage().contains(message), error::getMessage);
  }
}
