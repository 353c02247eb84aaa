package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import org.hificamsim.core.Reference;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests {@code import}, and other commands on its scenarios. */
class ImportCommandTest {
  private static final String OPEN = "geometric";

  @TempDir Path folder;
  private Path recording;
  private Path out;

  @BeforeEach
  void record() throws IOException {
    StringBuilder text = new StringBuilder();
    for (int frame = 0; frame < 30; frame++) {
      text.append(frame).append(" 1 ").append(frame).append(" 5\n");
      if (frame < 10 || frame >= 20) {
        text.append(frame).append(" 2 20 ").append(frame).append('\n');
      }
    }
    recording = Files.writeString(folder.resolve("people.txt"), text);
    out = folder.resolve("out");
  }

  private Cli imported(Object... more) {
    Object[] words = {"import", recording, "--format", "ethucy", "--rate", 2, "--out", out};
    Object[] arguments = Arrays.copyOf(words, words.length + more.length);
    System.arraycopy(more, 0, arguments, words.length, more.length);
    return Cli.run(arguments);
  }

  @Test
  void printsSummary() {
    Cli imported = imported();
    assertEquals(0, imported.exit(), imported.err());
    assertTrue(imported.out().contains("50 samples of 2 targets in 14.5 s"), imported::out);
    assertTrue(imported.out().contains("a sample every 0.5 s (2 a second)"), imported::out);
    assertTrue(imported.out().contains("1 gaps longer than 1.5 s, up to 5.5 s"), imported::out);
    assertTrue(imported.out().contains("hificamsim view "), imported::out);
    String question = "question: covered:k=1 by oodpcvs-2025:level=discern in 30 steps";
    assertTrue(imported.out().contains(question), imported::out);
    Cli validated = Cli.run("validate", out.resolve("people.xml"));
    assertTrue(validated.out().contains(" 50 samples of 2 targets, "), validated::out);
  }

  @Test
  void ignoresAbsentTargets() throws IOException {
    imported();
    Path run = folder.resolve("run");
    Cli ran =
        Cli.run(
            "run",
            out.resolve("people.xml"),
            "--detection",
            OPEN,
            "--steps",
            40,
            "--policy",
            "zoom-out",
            "--record",
            "--out",
            run);
    assertEquals(0, ran.exit(), ran.err());
    List<String> steps = Files.readAllLines(run.resolve("steps.csv"));
    int targets = List.of(steps.get(0).split(",")).indexOf("targets");
    assertEquals("2", steps.get(1).split(",")[targets]);
    assertEquals("1", steps.get(1 + 15).split(",")[targets]);
    assertEquals("2", steps.get(1 + 29).split(",")[targets]);
    assertEquals("0", steps.get(1 + 30).split(",")[targets]);
  }

  @Test
  void writesScenarioThatRunsWithoutTracksFile() throws IOException {
    imported();
    Path run = folder.resolve("run");
    Path again = folder.resolve("again");
    Cli.run("run", out.resolve("people.xml"), "--detection", OPEN, "--steps", 40, "--out", run);
    Files.delete(out.resolve("people.tracks"));
    Cli second =
        Cli.run(
            "run",
            run.resolve("scenario-people.xml"),
            "--detection",
            OPEN,
            "--steps",
            40,
            "--out",
            again);
    assertEquals(0, second.exit(), second.err());
    assertEquals(
        Files.readString(run.resolve("steps.csv")), Files.readString(again.resolve("steps.csv")));
  }

  @Test
  void comparesSameOnAnyNumberOfThreads() throws IOException {
    imported();
    for (int threads : new int[] {1, 3}) {
      Cli compared =
          Cli.run(
              "compare",
              out.resolve("people.xml"),
              "--detections",
              "dori-2014:level=observe",
              "--policies",
              "optimal,best-fixed,softmax,tracker",
              "--steps",
              30,
              "--repeat",
              3,
              "--threads",
              threads,
              "--out",
              folder.resolve("compare" + threads));
      assertEquals(0, compared.exit(), compared.err());
    }
    assertEquals(
        Files.readString(folder.resolve("compare1/results.csv")),
        Files.readString(folder.resolve("compare3/results.csv")));
  }

  @ParameterizedTest
  @ValueSource(strings = {"validate", "camsim"})
  void worksWithOtherCommands(String command) {
    imported();
    Path file = out.resolve("people.xml");
    Cli done =
        command.equals("camsim")
            ? Cli.run("camsim", "-o", folder.resolve("o.csv"), "-t", 20, file)
            : Cli.run(command, file);
    assertEquals(0, done.exit(), done.err());
  }

  @Test
  void addsWallsFloorPlanAndCameras() throws IOException {
    Path walls =
        Files.writeString(
            folder.resolve("w.xml"), "<T><Line x1='10.5' y1='0' x2='10.5' y2='9'/></T>");
    Path plan = folder.resolve("plan.png");
    ImageIO.write(new BufferedImage(80, 60, BufferedImage.TYPE_INT_RGB), "png", plan.toFile());
    Cli imported =
        imported(
            "--walls",
            walls,
            "--floorplan",
            plan,
            "--scale",
            0.5,
            "--at",
            "-5,-6",
            "--cameras",
            3,
            "--size",
            "0.5x1.75",
            "--step",
            1,
            "--name",
            "Platz-é");
    assertEquals(0, imported.exit(), imported.err());
    assertTrue(
        imported.out().contains("odd: through a wall: once, target 1 at 5.5 s"), imported::out);
    String xml = Files.readString(out.resolve("Platz-é.xml"));
    assertTrue(xml.contains("<wall x1=\"10.5\" y1=\"0.0\" x2=\"10.5\" y2=\"9.0\"/>"), xml);
    assertTrue(
        xml.contains(
            "floorplan=\"Platz-é-floorplan.png\" floorplan_min_x=\"-5.0\""
                + " floorplan_max_x=\"35.0\" floorplan_min_y=\"-6.0\" floorplan_max_y=\"24.0\""),
        xml);
    assertEquals(3, xml.split("<camera ").length - 1);
    assertTrue(Files.exists(out.resolve("Platz-é-floorplan.png")));
    Cli.assertValidAndRuns(out.resolve("Platz-é.xml"), folder.resolve("run"));
  }

  @Test
  void writesSameInAnyLocale() throws IOException {
    imported();
    String expected = Files.readString(out.resolve("people.tracks")) + imported().out();
    Locale before = Locale.getDefault();
    try {
      Locale.setDefault(Locale.forLanguageTag("ar-EG-u-nu-arab"));
      String printed = imported().out();
      assertEquals(expected, Files.readString(out.resolve("people.tracks")) + printed);
    } finally {
      Locale.setDefault(before);
    }
  }

  @Test
  void rejectsInvalidOptionsInOneLine() {
    imported("--gap", "-1").assertRejected("--gap is -1.0, expected a number above 0", out);
    imported("--size", "0x1").assertRejected("--size is '0x1', expected metres above 0", out);
    imported("--unit", "ft").assertRejected("--unit is 'ft', expected one of m, cm, mm, px", out);
    imported("--unit", "cm").assertRejected("--unit is cm, expected m or none", out);
    imported("--floorplan", recording)
        .assertRejected("people.txt: a picture without --scale M, expected how", out);
    imported("--cameras", 0).assertRejected("--cameras is 0, expected a whole number", out);
    imported("--name", "a/b").assertRejected("--name is 'a/b', expected letters", out);
    imported("--from", 9, "--to", 1).assertRejected("--to is 1.0, expected a number from 9.0", out);
    imported("--walls", recording).assertRejected("expected walls in a file that ends in", out);
    imported("--at", "1;2", "--scale", 1, "--walls", "w.svg")
        .assertRejected("--at is '1;2', expected two numbers", out);
    imported("--homography", recording)
        .assertRejected("expected a matrix of three rows of three numbers", out);
    imported("--origin", "95,1").assertRejected("--origin is 95.0", out);
    Cli.run("import", recording, "--format", "obsmatt", "--out", out)
        .assertRejected("unknown format 'obsmatt', expected one of obsmat", out);
    Cli.run("import", recording, "--format", "ethucy", "--out", out)
        .assertRejected("people.txt: expected --rate R, the frames per second", out);
    Cli.run("import", folder.resolve("none"), "--format", "fcd", "--out", out)
        .assertRejected("none:1:1: no such file, expected a file", out);
  }

  @Test
  void importsZara01WithWalls() {
    Path file = Reference.file("tracks/zara01-obsmat.txt");
    Cli imported =
        Cli.run(
            "import",
            file,
            "--format",
            "obsmat",
            "--rate",
            25,
            "--unit",
            "m",
            "--walls",
            Reference.file("tracks/zara01-map.xml"),
            "--out",
            out);
    assertEquals(0, imported.exit(), imported.err());
    assertTrue(imported.out().contains("5024 samples of 148 targets"), imported::out);
    Cli.assertValidAndRuns(out.resolve("zara01-obsmat.xml"), folder.resolve("run"));
  }
}
