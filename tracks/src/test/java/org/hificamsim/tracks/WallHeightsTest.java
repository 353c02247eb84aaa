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
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.LocalProjection;
import org.hificamsim.tracks.place.DraftCameras;
import org.hificamsim.tracks.place.WallFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WallHeightsTest {
  @TempDir Path folder;

  private List<Obstacle> read(String name, String text) throws IOException {
    Path file = Files.writeString(folder.resolve(name), text);
    return WallFile.read(file, Unit.M, new LocalProjection(), Optional.empty());
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
  void aFeatureHasItsOwnHeight() throws IOException {
    for (String height : List.of("1.8", "\"1.8\"")) {
      List<Obstacle> walls = read("walls.json", feature(height));
      assertEquals(new Obstacle.Wall(1, 2, 3, 4, 0, 0, 1.8), walls.get(0));
      assertEquals(new Obstacle.Wall(5, 6, 7, 8, 0), walls.get(1));
    }
    for (String height : List.of("-1", "\"high\"", "[]")) {
      InputException error =
          assertThrows(InputException.class, () -> read("walls.json", feature(height)));
      assertTrue(error.getMessage().contains("walls.json:1:"), error::getMessage);
    }
  }

  @Test
  void draftsHangWhereWallsHaveHeights() throws IOException {
    List<Obstacle> walls =
        read("walls.xml", "<Lines><Line x1='4' y1='5' x2='6' y2='5' height='1.2'/></Lines>");
    Field field = new Field(0, 40, 0, 30);
    CameraSpec hung = DraftCameras.of(1, field, new Obstacles(walls)).get(0);
    assertEquals(3, hung.z().orElseThrow());
    double half = Math.toDegrees(Math.atan(Math.tan(Math.toRadians(30)) * 9 / 16));
    assertEquals(half + Math.toDegrees(Math.atan(3 / 49.2)), hung.tilt(), 0.5);
    CameraSpec flat = DraftCameras.of(1, field, Obstacles.NONE).get(0);
    assertTrue(flat.z().isEmpty() && flat.tilt() == 0);
  }
}
