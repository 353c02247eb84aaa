package org.hificamsim.tracks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.zip.GZIPOutputStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacle.Wall;
import org.hificamsim.core.obstacle.Point;
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
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that SVG and CSS are read as their standards define them. */
class SvgWallsTest {
  private static final String LINE = "<line x2='10' y1='100' y2='100'%s/>";
  private static final Wall DRAWN = new Wall(0, 0, 10, 0, 0);

  @TempDir Path folder;

  private Drawing drawing(String svg, PlanScale scale, String... layers) {
    try {
      return read(Files.writeString(folder.resolve("a.svg"), svg), scale, layers);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static Drawing read(Path file, PlanScale scale, String... layers) {
    return WallFile.read(
        file,
        new DrawingSettings(
            Optional.empty(),
            Unit.M,
            new LocalProjection(),
            Optional.of(new PictureFrame(scale, 0, 0)),
            new LayerChoice(List.of(layers))));
  }

  /** The obstacles in a drawing of 100 m by 100 m. */
  private List<Obstacle> walls(String content) {
    return drawing("<svg viewBox='0 0 100 100'>" + content + "</svg>", new PlanScale.PerUnit(1))
        .obstacles(false);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "<g display='none'>%s</g>",
        "<g style='fill:#fff; display : none'>%s</g>",
        "<g visibility='hidden'><g>%s</g></g>",
        "<g visibility='collapse'>%s</g>",
        "<g opacity='0'>%s</g>",
        "<g style='stroke:none'>%s</g>",
        "<style>g.a > line {display:none}</style><g class='b a'>%s</g>",
        "<style>/* c */ #x line, path {display:none}</style><g id='x'><g>%s</g></g>",
        "<style>line{display:inline!important} line{display:none!important}</style>%s",
        "<style>@media print {line{}} @media screen {[x2='10']{visibility:hidden}}</style>%s",
        "<style>line{display:inline} g line{display:none}</style><g>%s</g>",
        "<switch><g/>%s</switch>",
      })
  void leavesOutHiddenElements(String container) {
    String hidden = container.formatted(LINE.formatted(" class='hidden'"));
    assertEquals(
        List.of(DRAWN),
        walls(
            LINE.formatted("")
                    .replace("line", "polyline")
                    .replace("x2='10' y1='100' y2='100'", "points='0,100 10,100'")
                + hidden));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "<g visibility='hidden'>%s</g>",
        "<style>line{display:none} #seen{display:inline}</style>%s",
        "<style>@media print{line{display:none}} @import 'b.css';"
            + " line:hover{display:none}</style>%s",
        "<style>line{display:none}</style><g>%s</g>",
        "<switch><foreignObject/>%s<g/></switch>",
        "<a>%s</a>",
        "<g stroke='none'>%s</g>",
      })
  void drawsElementsThatAreNotHidden(String container) {
    String line = LINE.formatted(" id='seen' style='visibility:visible;display:block;stroke:red'");
    assertEquals(List.of(DRAWN), walls(container.formatted(line)));
  }

  @Test
  void placesNestedDrawings() {
    String nested =
        "<svg x='20' y='10' width='40' height='20' viewBox='0 0 10 10'>"
            + "<line x2='100%' y2='10'/></svg>";
    assertEquals(List.of(new Wall(30, 90, 50, 70, 0)), walls(nested));
    String stretched = nested.replace("viewBox", "preserveAspectRatio='none' viewBox");
    assertEquals(List.of(new Wall(20, 90, 60, 70, 0)), walls(stretched));
    String corner = nested.replace("viewBox", "preserveAspectRatio='xMaxYMin slice' viewBox");
    assertEquals(List.of(new Wall(20, 90, 60, 50, 0)), walls(corner));
  }

  @Test
  void drawsElementsThatUseRefersTo() {
    String symbol =
        "<symbol id='s' viewBox='0 0 2 2'><line x2='2' y2='2'/></symbol>"
            + "<use href='#s' x='10' y='20' width='4' height='4' transform='scale(2)'/>";
    assertEquals(List.of(new Wall(20, 60, 28, 52, 0)), walls(symbol));
    String twice =
        "<defs><g id='g'><line x2='1' y2='0'/></g></defs>"
            + "<use xlink:href='#g' xmlns:xlink='http://www.w3.org/1999/xlink' y='100'/>"
            + "<g style='stroke:red'><use href='#g' x='5' y='100'/></g>";
    assertEquals(List.of(new Wall(0, 0, 1, 0, 0), new Wall(5, 0, 6, 0, 0)), walls(twice));
  }

  @Test
  void readsRoundShapes() {
    assertEquals(
        List.of(new Obstacle.Pillar(10, 90, 4, 0)),
        walls("<circle cx='5' cy='5' r='2' transform='scale(2)'/>"));
    List<Obstacle> squeezed = walls("<circle cx='5' cy='5' r='2' transform='scale(2 1)'/>");
    assertTrue(squeezed.get(0) instanceof Obstacle.Polygon, squeezed::toString);
    assertTrue(squeezed.get(0).contains(13.9, 95) && !squeezed.get(0).contains(10, 97.1));
    assertTrue(walls("<ellipse cx='50%' cy='50' rx='10' ry='5'/>").get(0).contains(59.9, 50));
    Obstacle round = walls("<rect width='10' height='10' rx='5'/>").get(0);
    assertTrue(round.contains(5, 95) && !round.contains(0.5, 99.5), round::toString);
  }

  @Test
  void makesWallsOfRectanglesWithoutFill() {
    String room = "<rect width='10' height='5' style='fill:none;stroke:#000'/>";
    assertEquals(4, walls(room).size());
    assertTrue(walls(room).stream().allMatch(wall -> wall instanceof Wall));
  }

  @Test
  void readsLengthsWithUnits() {
    String svg = "<svg width='2in' height='50.8mm'><line x2='%s' y1='1in' y2='1in'/></svg>";
    for (String length : List.of("96", "96px", "1in", "2.54cm", "25.4mm", "72pt", "6pc", "50%")) {
      Drawing drawing = drawing(svg.formatted(length), new PlanScale.PerUnit(1));
      assertEquals(List.of(new Wall(0, 96, 96, 96, 0)), drawing.obstacles(false), length);
    }
  }

  @Test
  void placesDrawingWithoutSizeAtItsLowerEdge() {
    assertEquals(
        List.of(new Wall(0, 20, 10, 0, 0)),
        drawing("<svg><line x2='10' y2='20'/></svg>", new PlanScale.PerUnit(1)).obstacles(false));
  }

  @Test
  void scalesByPaperAndByWidth() {
    String svg =
        "<svg width='210mm' viewBox='0 0 420 594'><line x1='20' x2='120' y1='594' y2='594'/></svg>";
    assertEquals(
        List.of(new Wall(1, 0, 6, 0, 0)), drawing(svg, new PlanScale.Paper(100)).obstacles(false));
    assertEquals(
        List.of(new Wall(4, 0, 24, 0, 0)), drawing(svg, new PlanScale.Width(20)).obstacles(false));
    InputException error =
        assertThrows(
            InputException.class,
            () -> drawing(svg.replace("210mm", "210"), new PlanScale.Paper(100)));
    assertTrue(error.getMessage().contains("no width in mm, cm or in"), error::getMessage);
  }

  @Test
  void countsOmittedElements() {
    Drawing drawing =
        drawing(
            "<svg viewBox='0 0 9 9'><text>a</text><image href='http://127.0.0.1:9/a.png'/>"
                + "<g display='none'><path d='M0,0 1,1'/><text/></g><use href='b.svg#a'/>"
                + "<use href='#none'/><use id='u' href='#u'/><line x2='1'/><title>t</title></svg>",
            new PlanScale.PerUnit(1));
    assertEquals(
        "left out: 1 hidden, 1 image, 1 text, 1 use of another file, 1 use of itself, 1 use of"
            + " nothing",
        drawing.leftOut().orElseThrow());
  }

  @Test
  void choosesByLayerClassIdAndColour() {
    String svg =
        "<svg viewBox='0 0 9 9' xmlns:inkscape='u:i'><style>.red{stroke:rgb(255, 0, 0)}</style>"
            + "<g inkscape:label='Walls' id='layer1'><line x2='1'/><line x2='2' class='red'/></g>"
            + "<g data-name='Doors'><line x2='3' stroke='#F00'/></g><line id='own' x2='4'/></svg>";
    assertEquals(2, choose(svg, "walls"));
    assertEquals(2, choose(svg, "layer1"));
    assertEquals(2, choose(svg, "#ff0000"));
    assertEquals(1, choose(svg, "red"));
    assertEquals(2, choose(svg, "own", "DOOR*"));
    List<String> lines = drawing(svg, new PlanScale.PerUnit(1)).labelLines();
    assertEquals(
        List.of(
            "class red: 1",
            "colour #ff0000: 2",
            "id of a group layer1: 2",
            "layer Walls: 2",
            "layer Doors: 1"),
        lines);
    InputException error = assertThrows(InputException.class, () -> choose(svg, "wals"));
    assertTrue(error.getMessage().contains("layers is 'wals', which nothing"), error::getMessage);
  }

  private int choose(String svg, String... layers) {
    return drawing(svg, new PlanScale.PerUnit(1), layers).obstacles(false).size();
  }

  @Test
  void readsPackedDrawingsOfDrawingPrograms() throws IOException {
    String svg =
        "<?xml version='1.0'?><!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN'"
            + " 'http://127.0.0.1:9/svg11.dtd' [<!ENTITY ns 'http://www.w3.org/2000/svg'>"
            + "<!ENTITY far SYSTEM 'file:///etc/hostname'>]>"
            + "<s:svg xmlns:s='&ns;' xmlns:o='u:o' viewBox='0 0 9 9'><o:line x2='7'/>"
            + "<s:line x2='2'/><s:text>&far;</s:text></s:svg>";
    Path file = folder.resolve("a.svgz");
    try (OutputStream out = new GZIPOutputStream(Files.newOutputStream(file))) {
      out.write(svg.getBytes(StandardCharsets.UTF_8));
    }
    assertEquals(
        List.of(new Wall(0, 9, 2, 9, 0)), read(file, new PlanScale.PerUnit(1)).obstacles(false));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "<!DOCTYPE svg",
        "<!DOCTYPE svg [<!ENTITY a 'b>]><svg/>",
        "<?a > ?><!-- > --><!DOCTYPE svg [<!-- ' --><!ENTITY a \"b\">",
      })
  void rejectsDocumentTypeWithoutEnd(String svg) {
    InputException error =
        assertThrows(InputException.class, () -> drawing(svg, new PlanScale.PerUnit(1)));
    assertTrue(error.getMessage().contains("document type is cut off, expected"), svg);
  }

  @Test
  void stopsExponentialExpansionOfEntities() {
    StringBuilder type = new StringBuilder("<!DOCTYPE svg [<!ENTITY e0 'aaaaaaaaaa'>");
    for (int i = 1; i < 12; i++) {
      type.append("<!ENTITY e").append(i).append(" '");
      type.append(("&e" + (i - 1) + ";").repeat(10)).append("'>");
    }
    String bomb = type + "]><svg height='9'><line x2='1'/><style>&e11;</style></svg>";
    InputException error =
        assertTimeoutPreemptively(
            Duration.ofSeconds(20),
            () ->
                assertThrows(InputException.class, () -> drawing(bomb, new PlanScale.PerUnit(1))));
    assertTrue(error.getMessage().contains("a.svg:1:"), error::getMessage);
  }

  @Test
  void stopsExponentialExpansionOfUse() {
    String bomb =
        IntStream.range(0, 30)
            .mapToObj(
                i ->
                    "<g id='g%s'>%s</g>"
                        .formatted(i, ("<use href='#g" + (i + 1) + "'/>").repeat(10)))
            .collect(Collectors.joining());
    InputException error =
        assertTimeoutPreemptively(
            Duration.ofSeconds(20),
            () -> assertThrows(InputException.class, () -> walls(bomb + "<g id='g30'/>")));
    assertTrue(error.getMessage().contains("<use> draws too much"), error::getMessage);
  }

  @Test
  void rejectsDrawingWithoutWalls() {
    InputException error =
        assertThrows(InputException.class, () -> walls("<text>a</text><image/>"));
    assertTrue(
        error.getMessage().contains("no wall is drawn (left out: 1 image, 1 text), expected"),
        error::getMessage);
  }

  @Test
  void makesBordersOfWalkableAreas() {
    String rooms =
        "<polygon points='0,100 10,100 10,90 0,90'/><polygon points='10,100 20,100 20,90 10,90'/>"
            + "<rect x='4' y='94' width='1' height='1'/>";
    List<Obstacle> walls =
        drawing("<svg viewBox='0 0 100 100'>" + rooms + "</svg>", new PlanScale.PerUnit(1))
            .obstacles(true);
    assertEquals(
        new Obstacle.Polygon(
            List.of(new Point(4, 6), new Point(5, 6), new Point(5, 5), new Point(4, 5)), 0),
        walls.get(0));
    double length =
        walls.stream()
            .skip(1)
            .map(Wall.class::cast)
            .mapToDouble(wall -> Math.hypot(wall.x2() - wall.x1(), wall.y2() - wall.y1()))
            .sum();
    assertEquals(60, length, 1e-9, "no wall between the rooms");
  }
}
