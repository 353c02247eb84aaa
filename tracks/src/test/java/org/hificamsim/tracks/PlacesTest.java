package org.hificamsim.tracks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Reference;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.LocalProjection;
import org.hificamsim.tracks.place.DraftCameras;
import org.hificamsim.tracks.place.DrawingSettings;
import org.hificamsim.tracks.place.LayerChoice;
import org.hificamsim.tracks.place.PeoplePositions;
import org.hificamsim.tracks.place.PictureFrame;
import org.hificamsim.tracks.place.PlanScale;
import org.hificamsim.tracks.place.WallFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests walls, floor plans and drafts of cameras. */
class PlacesTest {
  private static final PictureFrame FRAME = new PictureFrame(new PlanScale.PerUnit(0.5), 10, 20);

  @TempDir Path folder;

  @Test
  void readsWallsFromLinesOfXml() {
    assertEquals(
        List.of(new Obstacle.Wall(6, 2, 0, 2, 0)),
        walls(
            "a.xml",
            "<T xmlns='u:x'><L><Line x1='6.0' y1='2' x2='0' y2='2' thickness='1'/>"
                + "<Line x1='1' y1='1' x2='1' y2='1'/></L></T>",
            Unit.M));
  }

  @Test
  void readsWallsOfZara01() {
    Path file = Reference.file("tracks/zara01-map.xml");
    assertEquals(7, TestWalls.obstacles(file, Unit.M, Optional.empty()).size());
  }

  @Test
  void readsWallsAndPolygonsOfGeoJson() {
    String json =
        """
{"type": "FeatureCollection", "features": [
  {"type": "Feature", "geometry": {"type": "LineString", "coordinates": [[0, 0], [100, 0], [100, 50]]}},
  {"type": "Feature", "properties": {"type": "Polygon"}, "geometry":
    {"coordinates": [[[0, 0], [400, 0], [400, 300], [0, 0]]], "type": "Polygon"}}]}
""";
    assertEquals(
        List.of(
            new Obstacle.Wall(0, 0, 1, 0, 0),
            new Obstacle.Wall(1, 0, 1, 0.5, 0),
            new Obstacle.Polygon(List.of(new Point(0, 0), new Point(4, 0), new Point(4, 3)), 0)),
        walls("a.geojson", json, Unit.CM));
  }

  @Test
  void convertsPolygonsWithHolesToSides() {
    String json =
        "{\"type\": \"Polygon\", \"coordinates\": [[[0,0],[9,0],[9,9],[0,0]],"
            + "[[5,1],[6,1],[6,2],[5,1]]]}";
    assertEquals(6, walls("a.json", json, Unit.M).size());
  }

  @Test
  void projectsDegreesLikeTracks() {
    List<Obstacle> walls =
        WallFile.read(
                written(
                    "a.geojson", "{\"type\":\"LineString\",\"coordinates\":[[16,48],[16.001,48]]}"),
                new DrawingSettings(
                    Optional.empty(),
                    Unit.DEG,
                    new LocalProjection(16, 48),
                    Optional.empty(),
                    LayerChoice.ALL))
            .obstacles(false);
    assertEquals(List.of(new Obstacle.Wall(0, 0, 74.625, 0, 0)), walls);
  }

  @Test
  void convertsDrawingToAxesOfField() {
    String svg =
        """
        <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 200 100">
          <defs><line x1="0" y1="0" x2="9" y2="9"/></defs>
          <g transform="translate(10, 0) scale(2)"><line x1="0" y1="0" x2="5" y2="10"/></g>
          <rect x="0" y="80" width="40" height="20"/>
          <path d="M0,0 h10 v10 H0 z m20 0 5 5"/>
          <polyline points="0,50 10,50 10,60"/>
        </svg>
        """;
    assertEquals(
        List.of(
            new Obstacle.Wall(15, 70, 20, 60, 0),
            new Obstacle.Polygon(
                List.of(new Point(10, 30), new Point(30, 30), new Point(30, 20), new Point(10, 20)),
                0),
            new Obstacle.Wall(10, 70, 15, 70, 0),
            new Obstacle.Wall(15, 70, 15, 65, 0),
            new Obstacle.Wall(15, 65, 10, 65, 0),
            new Obstacle.Wall(10, 65, 10, 70, 0),
            new Obstacle.Wall(20, 70, 22.5, 67.5, 0),
            new Obstacle.Wall(10, 45, 15, 45, 0),
            new Obstacle.Wall(15, 45, 15, 40, 0)),
        walls("a.svg", svg, Unit.M));
  }

  @Test
  void convertsCurvesToChords() {
    List<Obstacle> walls =
        walls("a.svg", "<svg height='100'><path d='M0,0 a20,20 0 0 1 20,20'/></svg>", Unit.M);
    assertTrue(walls.size() >= 4, walls::toString);
    Obstacle.Wall first = (Obstacle.Wall) walls.get(0);
    Obstacle.Wall last = (Obstacle.Wall) walls.get(walls.size() - 1);
    assertEquals(List.of(10.0, 70.0), List.of(first.x1(), first.y1()));
    assertEquals(List.of(20.0, 60.0), List.of(last.x2(), last.y2()));
    for (Obstacle obstacle : walls) {
      Obstacle.Wall wall = (Obstacle.Wall) obstacle;
      double middleX = (wall.x1() + wall.x2()) / 2;
      double middleY = (wall.y1() + wall.y2()) / 2;
      assertEquals(10, Math.hypot(middleX - 10, middleY - 60), 0.03, wall::toString);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "a.svg|<svg><line/></svg>|a.svg: all that is drawn are points, expected lines",
        "a.svg|<svg height='10'><g transform='turn(3)'/></svg>|<g> transform is 'turn(3)'",
        "a.svg|<svg height='10'><polygon points='1 2 3'/></svg>|<polygon> points is '1 2 3'",
        "a.svg|<svg height='10'><polyline points='1 4e9'/></svg>|a point is at 10.5, -1.9",
        "a.svg|<svg height='10'><line x1='9e8' transform='scale(4)'/></svg>|a point is at 1.8",
        "a.svg|<svg height='10'><path d='L1'/></svg>|<path> d is 'L1'",
        "a.svg|<svg height='10'><path d='M0,0 h1 ?'/></svg>|<path> d is 'M0,0 h1 ?'",
        "a.svg|<svg height='10 10'/>|<svg> height is '10 10'",
        "a.svg|<svg viewBox='0 0 9'/>|<svg> viewBox is '0 0 9'",
        "a.xml|<T><Line x1='1' y1='1' x2='NaN' y2='2'/></T>|:1:41: <Line> x2 is 'NaN', expected",
        "a.xml|<T><Line x1='1'|cut off",
        "a.json|{\"type\": \"LineString\", \"coordinates\": [[0, \"x\"]]}|a coordinate is 'x'",
        "a.json|[]|:1:1: expected a GeoJSON object",
        "a.wkt|LINESTRING (1 2, 3)|a.wkt:1:1: Expected number",
        "a.wkt|LINESTRING (1 NaN, 3 4)|a.wkt:1:1: a coordinate is",
        "a.wkt|wall (1 2)|a.wkt:1:1: Unknown geometry type",
        "a.plt|0|expected walls in a file that ends in .svg, .svgz, .dxf, .geojson, .json, .wkt",
      })
  void rejectsInvalidWalls(String name, String content, String message) {
    InputException error = assertThrows(InputException.class, () -> walls(name, content, Unit.M));
    assertTrue(error.getMessage().contains(message), error::getMessage);
  }

  @Test
  void requiresScaleForDrawings() {
    Path file = written("a.svg", "<svg height='10'/>");
    InputException error =
        assertThrows(
            InputException.class, () -> TestWalls.obstacles(file, Unit.M, Optional.empty()));
    assertTrue(error.getMessage().endsWith("the metres of a unit of the drawing"));
  }

  @Test
  void computesAreaOfFloorPlan() throws IOException {
    Path file = folder.resolve("plan.png");
    ImageIO.write(new BufferedImage(40, 20, BufferedImage.TYPE_INT_RGB), "png", file.toFile());
    assertEquals(new Field(10, 30, 20, 30), FRAME.area(file));
    Path text = written("plan.txt", "no picture");
    assertThrows(InputException.class, () -> FRAME.area(text));
  }

  @Test
  void placesDraftCamerasOnBorderLookingInside() {
    Field field = new Field(0, 100, 0, 50);
    Obstacles walls = new Obstacles(List.of(new Obstacle.Pillar(0, 0, 3, 0)));
    List<CameraSpec> cameras =
        new DraftCameras(field, walls, new PeoplePositions(), 6, 80).cameras();
    assertEquals(
        6, cameras.stream().map(camera -> camera.x() + " " + camera.y()).distinct().count());
    for (CameraSpec camera : cameras) {
      assertTrue(field.contains(camera.x(), camera.y()), camera::toString);
      assertTrue(walls.containing(camera.x(), camera.y()).isEmpty(), camera::toString);
      double towards = Math.toRadians(camera.heading());
      double ahead = Math.sin(towards) * (50 - camera.x()) + Math.cos(towards) * (25 - camera.y());
      assertEquals(Math.hypot(50 - camera.x(), 25 - camera.y()), ahead, 0.01, camera::toString);
    }
  }

  private List<Obstacle> walls(String name, String content, Unit unit) {
    return TestWalls.obstacles(written(name, content), unit, Optional.of(FRAME));
  }

  private Path written(String name, String content) {
    try {
      return Files.writeString(folder.resolve(name), content);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
