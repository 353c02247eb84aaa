package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that {@code import} notices walls that it has probably read wrongly. */
class PlausibilityTest {
  private static final Path CASES = Cli.ROOT.resolve("src/test/resources/cases");

  @TempDir Path folder;
  private Path out;

  @BeforeEach
  void setOutputFolder() {
    out = folder.resolve("out");
  }

  private Cli imported(Path people, Path walls, Object... more) {
    List<Object> words = new ArrayList<>(List.of("import", people, "--format", "petrack"));
    words.addAll(List.of("--walls", walls, "--out", out));
    words.addAll(List.of(more));
    return Cli.run(words.toArray());
  }

  private Cli importedCase(String name, String walls, Object... more) {
    Path files = CASES.resolve(name);
    return imported(files.resolve("people.txt"), files.resolve(walls), more);
  }

  private Path write(String name, String text) throws IOException {
    return Files.writeString(folder.resolve(name), text);
  }

  @Test
  void rejectsSolidThatContainsAllSamples() {
    importedCase("walkable-wkt", "room.wkt")
        .assertRejected(
            "holds 100 % of the samples: it is probably the area that people walk", out);
    Cli forced = importedCase("walkable-wkt", "room.wkt", "--force-reading");
    assertEquals(0, forced.exit(), forced.err());
    assertTrue(forced.err().startsWith("warning: a solid of the walls holds"), forced.err());
    assertTrue(forced.err().contains("expected --walkable, which makes"), forced.err());
  }

  @ParameterizedTest
  @CsvSource({
    "walkable-wkt, room.wkt, --walkable, 4",
    "jps-xml-walls, geometry.xml, --force-reading, 2",
    "svg-hidden, plan.svg, --scale=1, 1",
    "svg-mm, plan.svg, --scale=0.1, 1",
    "svg-mm, unit-attr.svg, --scale=0.1, 2",
    "svg-use-circle, plan.svg, --scale=1, 6",
    "geojson-height-unit, buildings.geojson, --margin=1, 2",
  })
  void readsWallsOfCases(String name, String walls, String option, int count) {
    Cli imported = importedCase(name, walls, option);
    assertEquals(0, imported.exit(), imported.err());
    assertTrue(imported.out().contains("walls and solids: " + count + "\n"), imported::out);
    assertEquals(name.equals("svg-hidden"), imported.out().contains("left out: 4 hidden\n"));
    assertEquals(0, Cli.run("validate", out.resolve("people.xml")).exit());
  }

  @Test
  void rejectsWallsThatEveryTrackCrosses() throws IOException {
    Path people =
        write(
            "people.txt",
            "# framerate: 1\n# id frame x/m y/m\n1 0 1 2\n1 1 9 2\n2 0 1 3\n2 1 9 3\n");
    Path wall = write("walls.wkt", "LINESTRING (500 0, 500 900)");
    imported(people, wall, "--walls-unit", "cm")
        .assertRejected("expected another --walls-unit, --scale or --at, or --force-reading", out);
    assertEquals(0, imported(people, wall).exit());
  }

  @Test
  void acceptsWallThatOneTrackCrosses() throws IOException {
    Path people =
        write(
            "people.txt",
            "# framerate: 1\n# id frame x/m y/m\n1 0 1 2\n1 1 9 2\n2 0 1 3\n2 1 2 3\n");
    Cli imported = imported(people, write("walls.wkt", "LINESTRING (5 0, 5 9)"));
    assertEquals(0, imported.exit(), imported.err());
    assertTrue(imported.out().contains("odd: through a wall: once"), imported::out);
  }

  @Test
  void placesDraftCamerasInsideWalls() throws IOException {
    Cli imported = importedCase("draft-outside-walls", "room.wkt");
    assertEquals("", imported.err());
    Path run = folder.resolve("run");
    Cli ran =
        Cli.run(
            "run",
            out.resolve("people.xml"),
            "--policy",
            "optimal",
            "--detection",
            "geometric",
            "--out",
            run);
    assertEquals(0, ran.exit(), ran.err());
    List<String> steps = Files.readAllLines(run.resolve("steps.csv"));
    int covered = List.of(steps.get(0).split(",")).indexOf("k_min");
    assertEquals(
        3, steps.stream().skip(1).filter(row -> !row.split(",")[covered].equals("0")).count());
  }

  @Test
  void warnsIfDraftCamerasSeeNobody() throws IOException {
    Path people =
        write(
            "people.txt", "# framerate: 1\n# id frame x/m y/m\n1 0 10 10\n1 1 10.1 10\n2 0 0 0\n");
    Path cell =
        write(
            "cell.wkt",
            "LINESTRING (9.9 9.9, 10.2 9.9, 10.2 10.1, 9.9 10.1, 9.9 9.9) "
                + "LINESTRING (-0.1 -0.1, 0.1 -0.1, 0.1 0.1, -0.1 0.1, -0.1 -0.1)");
    Cli imported = imported(people, cell);
    assertEquals(0, imported.exit(), imported.err());
    assertTrue(
        imported.err().contains("walls hide everybody from the draft cameras"), imported.err());
  }
}
