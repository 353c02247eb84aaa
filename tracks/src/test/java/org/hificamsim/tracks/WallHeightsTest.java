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
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.place.DraftCameras;
import org.hificamsim.tracks.place.PeoplePositions;
import org.hificamsim.tracks.place.PictureFrame;
import org.hificamsim.tracks.place.PlanScale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WallHeightsTest {
  @TempDir Path folder;

  private List<Obstacle> read(String name, String text) throws IOException {
    Path file = Files.writeString(folder.resolve(name), text);
    return TestWalls.obstacles(file, Unit.M, Optional.empty());
  }

  private static String feature(String height) {
    return "{\"type\": \"FeatureCollection\", \"features\": [{\"type\": \"Feature\", \"geometry\":"
        + " {\"type\": \"LineString\", \"coordinates\": [[1, 2], [3, 4]]}, \"properties\":"
        + " {\"height\": "
        + height
        + "}}, {\"type\": \"Feature\", \"properties\": {}, \"geometry\": {\"type\":"
        + " \"LineString\", \"coordinates\": [[5, 6], [7, 8]]}}]}";
  }

  @Test
  void readsHeightsOfFeatures() throws IOException {
    for (String height : List.of("1.8", "\"1.8\"")) {
      List<Obstacle> walls = read("walls.json", feature(height));
      assertEquals(new Obstacle.Wall(1, 2, 3, 4, 0, 0, 1.8), walls.get(0));
      assertEquals(new Obstacle.Wall(5, 6, 7, 8, 0), walls.get(1));
    }
  }

  @Test
  void readsZOfWellKnownTextAsHeight() throws IOException {
    List<Obstacle> walls =
        read(
            "walls.wkt",
            "LINESTRING (5 6, 7 8)\n\n"
                + "GEOMETRYCOLLECTION Z (LINESTRING Z (1 2 1.8, 3 4 1.8),\n POINT Z (9 9 9))\n"
                + "POLYGON ((0 0, 4 0, 4 4, 0 0)) POLYGON EMPTY\n"
                + "POLYGON Z ((0 0 3, 9 0 3, 9 9 3, 0 0 3), (2 1 3, 3 1 3, 3 2 3, 2 1 3))\n");
    assertEquals(new Obstacle.Wall(5, 6, 7, 8, 0), walls.get(0));
    assertEquals(new Obstacle.Wall(1, 2, 3, 4, 0, 0, 1.8), walls.get(1));
    assertTrue(walls.get(2) instanceof Obstacle.Polygon, () -> walls.get(2).toString());
    assertEquals(new Obstacle.Wall(0, 0, 9, 0, 0, 0, 3), walls.get(3));
    assertEquals(9, walls.size(), "the sides of a polygon with a hole");
    InputException error =
        assertThrows(
            InputException.class,
            () -> read("a.wkt", "SRID=25832;LINESTRING (5 6, 7 8)\nLINESTRING (1 2,\n x)"));
    assertTrue(error.getMessage().contains("a.wkt:3:1: "), error::getMessage);
  }

  @Test
  void readsHeightsOfShapesInMetres() throws IOException {
    String drawing =
        "<svg width='40' height='30'><g transform='scale(2)'>"
            + "<line x1='1' y1='2' x2='3' y2='4' data-height='1.8'/>"
            + "<rect x='5' y='5' width='2' height='1'/></g></svg>";
    Path file = Files.writeString(folder.resolve("a.svg"), drawing);
    PictureFrame frame = new PictureFrame(new PlanScale.PerUnit(0.5), 0, 0);
    List<Obstacle> walls = TestWalls.obstacles(file, Unit.M, Optional.of(frame));
    assertEquals(1.8, ((Obstacle.Wall) walls.get(0)).height());
    assertEquals(Double.POSITIVE_INFINITY, ((Obstacle.Polygon) walls.get(1)).height());
    for (String height : List.of("0", "tall", "")) {
      Path broken = Files.writeString(folder.resolve("b.svg"), drawing.replace("1.8", height));
      Obstacle wall = TestWalls.obstacles(broken, Unit.M, Optional.of(frame)).get(0);
      assertEquals(Double.POSITIVE_INFINITY, ((Obstacle.Wall) wall).height(), height);
    }
  }

  @Test
  void hangsDraftCamerasIfWallsHaveHeights() throws IOException {
    List<Obstacle> walls =
        read("walls.xml", "<Lines><Line x1='4' y1='5' x2='6' y2='5' height='1.2'/></Lines>");
    Field field = new Field(100, 140, -50, -20);
    CameraSpec hung =
        new DraftCameras(field, new Obstacles(walls), new PeoplePositions(), 1, 80)
            .cameras()
            .get(0);
    assertEquals(3, hung.z().orElseThrow());
    double half = Math.toDegrees(Math.atan(Math.tan(Math.toRadians(30)) * 9 / 16));
    assertEquals(half + Math.toDegrees(Math.atan(3 / 49.2)), hung.tilt(), 0.5);
    CameraSpec flat =
        new DraftCameras(field, Obstacles.NONE, new PeoplePositions(), 1, 80).cameras().get(0);
    assertTrue(flat.z().isEmpty() && flat.tilt() == 0);
  }
}
