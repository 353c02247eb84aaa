package org.hificamsim.tracks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacle.Pillar;
import org.hificamsim.core.obstacle.Obstacle.Wall;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.LocalProjection;
import org.hificamsim.tracks.place.Drawing;
import org.hificamsim.tracks.place.DrawingSettings;
import org.hificamsim.tracks.place.LayerChoice;
import org.hificamsim.tracks.place.WallFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DxfWallsTest {
  private static final String LINE = "0 LINE 10 0 20 0 11 4 21 0 ";
  private static final long MEGABYTE = 1 << 20;

  @TempDir Path folder;

  /** Puts each word into a line of its own, with {@code _} for blanks within. */
  private static String pairs(String words) {
    return words.strip().replaceAll("\\s+", "\n").replace('_', ' ') + "\n";
  }

  /** A file in metres. */
  private static String dxf(String tables, String blocks, String entities) {
    return pairs(
        "0 SECTION 2 HEADER 9 $INSUNITS 70 6 0 ENDSEC 0 SECTION 2 TABLES "
            + tables
            + " 0 ENDSEC 0 SECTION 2 BLOCKS "
            + blocks
            + " 0 ENDSEC 0 SECTION 2 ENTITIES "
            + entities
            + " 0 ENDSEC 0 EOF");
  }

  private Drawing drawing(String text, Charset encoding, String... layers) {
    try {
      Path file = Files.write(folder.resolve("a.dxf"), text.getBytes(encoding));
      return WallFile.read(
          file,
          new DrawingSettings(
              Optional.empty(),
              Unit.M,
              new LocalProjection(),
              Optional.empty(),
              new LayerChoice(List.of(layers))));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private List<Obstacle> walls(String entities) {
    return drawing(dxf("", "", entities), StandardCharsets.UTF_8).obstacles(false);
  }

  @Test
  void convertsUnitsOfFile() {
    String inches = dxf("", "", LINE).replace("70\n6\n", "70\n1\n");
    assertEquals(
        List.of(new Wall(0, 0, 0.102, 0, 0)),
        drawing(inches, StandardCharsets.UTF_8).obstacles(false));
  }

  @Test
  void readsPolylinesWithBulges() {
    List<Obstacle> walls = walls("0 LWPOLYLINE 90 2 70 1 10 0 20 0 42 1 10 2 20 0 10 2 20 3");
    assertEquals(new Wall(2, 0, 2, 3, 0), walls.get(walls.size() - 2));
    assertEquals(new Wall(2, 3, 0, 0, 0), walls.get(walls.size() - 1));
    assertOnCircle(walls.subList(0, walls.size() - 2), 1, 0, 1);
    assertTrue(
        walls.stream().anyMatch(wall -> wall.touches(1, -2, 1, -0.5)),
        "a positive bulge goes below");
    String old = "0 POLYLINE 66 1 70 0 0 VERTEX 10 0 20 0 42 -1 0 VERTEX 10 2 20 0 0 SEQEND ";
    List<Obstacle> half = walls(old);
    assertOnCircle(half, 1, 0, 1);
    assertTrue(half.stream().allMatch(wall -> ((Wall) wall).y1() >= 0), half::toString);
  }

  private static void assertOnCircle(List<Obstacle> walls, double x, double y, double radius) {
    assertTrue(walls.size() >= 4, walls::toString);
    for (Obstacle obstacle : walls) {
      Wall wall = (Wall) obstacle;
      assertEquals(radius, Math.hypot(wall.x1() - x, wall.y1() - y), 0.002, wall::toString);
      double middle = Math.hypot((wall.x1() + wall.x2()) / 2 - x, (wall.y1() + wall.y2()) / 2 - y);
      assertEquals(radius, middle, 0.03, wall::toString);
    }
  }

  @Test
  void readsCurves() {
    List<Obstacle> arc = walls("0 ARC 10 5 20 5 40 2 50 350 51 80");
    assertOnCircle(arc, 5, 5, 2);
    assertTrue(arc.stream().allMatch(wall -> ((Wall) wall).x1() > 5), arc::toString);
    List<Obstacle> mirrored = walls("0 ARC 10 5 20 5 40 2 50 350 51 80 230 -1");
    assertOnCircle(mirrored, -5, 5, 2);
    assertEquals(List.of(new Pillar(1, 2, 3, 0)), walls("0 CIRCLE 10 1 20 2 40 3"));
    Obstacle ellipse = walls("0 ELLIPSE 10 0 20 0 11 0 21 4 40 0.5 41 0 42 6.283185307").get(0);
    assertTrue(ellipse.contains(0, 3.9) && ellipse.contains(1.9, 0) && !ellipse.contains(2.1, 0));
    List<Obstacle> quarter = walls("0 ELLIPSE 10 0 20 0 11 2 21 0 40 1 41 0 42 1.570796");
    assertOnCircle(quarter, 0, 0, 2);
    assertTrue(quarter.stream().allMatch(wall -> ((Wall) wall).y2() >= 0), quarter::toString);
    Obstacle solid = walls("0 SOLID 10 0 20 0 11 2 21 0 12 0 22 1 13 2 23 1").get(0);
    assertTrue(solid.contains(1, 0.9) && !solid.contains(1, 1.1));
  }

  @Test
  void flattensRationalSplines() {
    String quarter =
        "0 SPLINE 71 2 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 0.70710678 41 1"
            + " 10 1 20 0 10 1 20 1 10 0 20 1";
    List<Obstacle> walls = walls(quarter);
    assertOnCircle(walls, 0, 0, 1);
    Wall last = (Wall) walls.get(walls.size() - 1);
    assertEquals(List.of(0.0, 1.0), List.of(last.x2(), last.y2()));
    assertEquals(2, walls("0 SPLINE 71 3 11 0 21 0 11 1 21 0 11 1 21 1").size());
  }

  @Test
  void drawsNestedBlocksOnTheirLayers() {
    String blocks =
        "0 BLOCK 2 COL 10 1 20 1 0 CIRCLE 8 0 10 1 20 1 40 0.5 0 ENDBLK "
            + "0 BLOCK 2 PAIR 10 0 20 0 0 INSERT 8 0 2 COL 10 0 20 0 "
            + "0 INSERT 8 0 2 COL 10 3 20 0 41 2 42 2 0 ENDBLK ";
    String insert =
        "0 INSERT 8 COLUMNS 66 1 2 PAIR 10 10 20 0 50 90 70 2 44 5 0 ATTRIB 1 x 0 SEQEND ";
    String text = dxf("", blocks, insert + LINE);
    assertEquals(
        List.of(
            new Pillar(10, 0, 0.5, 0),
            new Pillar(10, 3, 1, 0),
            new Pillar(10, 5, 0.5, 0),
            new Pillar(10, 8, 1, 0)),
        drawing(text, StandardCharsets.UTF_8, "columns").obstacles(false));
    List<String> labels = drawing(text, StandardCharsets.UTF_8).labelLines();
    assertEquals(
        List.of("block COL: 4", "block PAIR: 4", "colour 7: 5", "layer COLUMNS: 4", "layer 0: 1"),
        labels);
  }

  @Test
  void leavesOutAndCountsOtherEntities() {
    String layers = "0 LAYER 2 OFF 70 0 62 -7 0 LAYER 2 ICE 70 1 62 7 0 LAYER 2 LOCKED 70 4 62 7 ";
    String blocks = "0 BLOCK 2 FAR 70 4 1 http://127.0.0.1:9/far.dxf 0 ENDBLK ";
    String entities =
        "0 LINE 8 OFF 0 LINE 8 ice 0 TEXT 1 a 0 TEXT 1 b 0 HATCH 0 LINE 67 1 0 LINE 60 1 "
            + "0 INSERT 2 FAR 0 INSERT 2 NONE 0 CIRCLE 40 1 210 1 230 0 "
            + LINE.replace("10 0", "8 LOCKED 10 0");
    Drawing drawing = drawing(dxf(layers, blocks, entities), StandardCharsets.UTF_8);
    assertEquals(
        "left out: 1 hatch, 1 hidden, 1 in paper space, 1 insert of another file, 1 insert of"
            + " nothing, 2 on layers that are off or frozen, 2 text, 1 upright circle",
        drawing.leftOut().orElseThrow());
    assertEquals(List.of(new Wall(0, 0, 4, 0, 0)), drawing.obstacles(false));
  }

  @Test
  void readsNamesInOldAndNewEncodings() {
    String line = dxf("", "", LINE.replace("10 0", "8 WÄNDE 10 0"));
    Charset windows = Charset.forName("windows-1252");
    assertEquals(1, drawing(line, windows, "WÄNDE").obstacles(false).size());
    assertEquals(1, drawing(line, StandardCharsets.UTF_8, "wände").obstacles(false).size());
    String escaped = line.replace("WÄNDE", "W\\U+00C4NDE").replace("\n", "\r\n");
    assertEquals(1, drawing(escaped, windows, "W*E").obstacles(false).size());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "AutoCAD Binary DXF/|a.dxf:1:1: the file is a binary DXF, expected DXF in ASCII",
        "AC1032|a.dxf:1:1: the file is a DWG, expected DXF in ASCII",
        "0/SECTION/2/HEADER|a.dxf:5:1: the file is cut off, expected an ASCII DXF",
        "0/SECTION/x/ENTITIES|a.dxf:3:1: group code is 'x', expected a whole number",
        "1/SECTION/0/EOF|a.dxf:2:1: expected a section, or EOF",
        "0/EOF|a.dxf: no wall is drawn, expected lines",
      })
  void rejectsFilesThatAreNotDxf(String text, String message) {
    String content = text.replace('/', '\n');
    InputException error =
        assertThrows(InputException.class, () -> drawing(content, StandardCharsets.UTF_8));
    assertTrue(error.getMessage().contains(message), error::getMessage);
  }

  @ParameterizedTest
  @CsvSource({
    "0 LINE 10 x, group 10 is 'x'; expected a number",
    "0 SPLINE 71 3 40 0 10 1 20 1, 'SPLINE has degree 3, 1 points and 1 knots; expected rising'",
    "0 LINE 10 1e80 11 2, a point is at 1.0E80; expected numbers from -1e9",
    "0 LINE 62 1e99, group 62 of LINE is 1.0E99; expected a whole number",
  })
  void rejectsInvalidEntities(String entity, String message) {
    InputException error = assertThrows(InputException.class, () -> walls(entity));
    for (String part : message.split("; ")) {
      assertTrue(error.getMessage().contains(part), error::getMessage);
    }
  }

  @Test
  void stopsBlocksThatInsertEachOther() {
    String selfInserting = "0 BLOCK 2 A 0 INSERT 2 A 0 LINE 11 1 0 ENDBLK ";
    Drawing drawing = drawing(dxf("", selfInserting, "0 INSERT 2 A"), StandardCharsets.UTF_8);
    assertEquals("left out: 1 insert of itself", drawing.leftOut().orElseThrow());
    StringBuilder bomb = new StringBuilder();
    for (int i = 0; i < 30; i++) {
      bomb.append(" 0 BLOCK 2 B").append(i);
      bomb.append((" 0 INSERT 2 B" + (i + 1)).repeat(10)).append(" 0 ENDBLK");
    }
    bomb.append(" 0 BLOCK 2 B30 0 POINT 0 ENDBLK");
    InputException error =
        assertTimeoutPreemptively(
            Duration.ofSeconds(20),
            () ->
                assertThrows(
                    InputException.class,
                    () -> drawing(dxf("", bomb + "", "0 INSERT 2 B0"), StandardCharsets.UTF_8)));
    assertTrue(error.getMessage().contains("INSERT draws too much"), error::getMessage);
    assertThrows(
        InputException.class,
        () ->
            drawing(
                dxf("", selfInserting, "0 INSERT 2 A 70 32767 71 32767"), StandardCharsets.UTF_8));
  }

  @Test
  void listsLayersOfDrawingThatIsTooLarge() throws IOException {
    String lines = pairs(LINE + "8 MANY ").repeat(200_001);
    Path file =
        Files.writeString(
            folder.resolve("many.dxf"),
            pairs("0 SECTION 2 ENTITIES ") + lines + pairs("0 ENDSEC 0 EOF"));
    InputException error = assertThrows(InputException.class, () -> read(file, LayerChoice.ALL));
    assertTrue(error.getMessage().contains("choose some by layers"), error::getMessage);
    Drawing listed = read(file, LayerChoice.FOR_LIST);
    assertEquals(List.of("colour 7: 200001", "layer MANY: 200001"), listed.labelLines());
  }

  private static Drawing read(Path file, LayerChoice choice) {
    return WallFile.read(
        file,
        new DrawingSettings(
            Optional.of(Unit.M), Unit.M, new LocalProjection(), Optional.empty(), choice));
  }

  @Test
  void readsHundredMegabytesWithLittleMemory() throws IOException {
    Path file = folder.resolve("big.dxf");
    String point = pairs("0 TEXT 8 NOTES 10 1.5 20 2.5 40 0.2 1 a_long_note_about_nothing");
    try (Writer out = Files.newBufferedWriter(file)) {
      out.write(pairs("0 SECTION 2 ENTITIES " + LINE));
      for (long written = 0; written < 100 * MEGABYTE; written += point.length()) {
        out.write(point);
      }
      out.write(pairs("0 ENDSEC 0 EOF"));
    }
    DrawingSettings settings =
        new DrawingSettings(
            Optional.of(Unit.M), Unit.M, new LocalProjection(), Optional.empty(), LayerChoice.ALL);
    assertTimeoutPreemptively(
        Duration.ofSeconds(60),
        () -> assertEquals(1, WallFile.read(file, settings).obstacles(false).size()));
  }
}
