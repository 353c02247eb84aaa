package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests {@code profile check} on a synthetic recording. Its camera is level, two metres above the
 * ground, looks along y and has a focal length of 800 pixels; the boxes of its people, of 1.75 x
 * 0.5 m, are 4 % too small.
 */
class ProfileCheckTest {
  private static final double SCALE_OF_BOXES = 1 / 1.04;

  @TempDir Path folder;
  private Path boxes;
  private Path xml;
  private Path matrix;

  @BeforeEach
  void writeRecording() throws IOException {
    boxes = Files.writeString(folder.resolve("gt.txt"), rows(true));
    xml =
        Files.writeString(
            folder.resolve("camera.xml"),
            """
<?xml version="1.0" encoding="UTF-8"?>
<Camera name="made">
  <Geometry width="1600" height="1200" ncx="1600" nfx="1600" dx="0.01" dy="0.01" dpx="0.01" dpy="0.01"/>
  <Intrinsic focal="8" kappa1="0" cx="800" cy="600" sx="1"/>
  <Extrinsic tx="0" ty="2000" tz="0" rx="1.5707963267948966" ry="0" rz="0"/>
</Camera>
""");
    matrix =
        Files.writeString(
            folder.resolve("camera.txt"),
            """
# K R | K t, metres
800 800 0 0
0 600 -800 1600
0 1 0 0
""");
  }

  /** Returns rows for 60 people, who stand ahead of the camera and to its sides. */
  private static String rows(boolean world) {
    List<String> rows = new ArrayList<>();
    for (int i = 0; i < 60; i++) {
      double x = i % 5 - 2;
      double y = 8 + i * 0.5;
      double u = 800 + 800 * x / y;
      double v = 600 + 800 * 2 / y;
      double height = 800 * 1.75 / y * SCALE_OF_BOXES;
      double width = 800 * 0.5 / y * SCALE_OF_BOXES;
      rows.add(
          String.format(
              Locale.ROOT,
              "%d,%d,%.6f,%.6f,%.6f,%.6f,1,%s",
              1 + i / 5,
              i % 5,
              u - width / 2,
              v - height,
              width,
              height,
              world ? x + "," + y + ",0" : "-1,-1,-1"));
    }
    return String.join("\n", rows) + "\n";
  }

  /** Returns the mean factor by which people to the side who face the camera look wider. */
  private static double wider() {
    double sum = 0;
    for (int i = 0; i < 60; i++) {
      sum += Math.hypot(i % 5 - 2, 8 + i * 0.5) / (8 + i * 0.5);
    }
    return sum / 60;
  }

  private Cli check(Object... more) {
    return Cli.run(
        Stream.concat(
                Stream.of("profile", "check", boxes, "--out", folder.resolve("out")),
                Stream.of(more))
            .toArray());
  }

  private List<String[]> table(String name) throws IOException {
    return Files.readAllLines(folder.resolve("out").resolve(name)).stream()
        .skip(1)
        .map(line -> line.split(","))
        .toList();
  }

  @Test
  void findsKnownErrorWithXmlCalibration() throws IOException {
    Cli cli = check("--calibration", xml);
    assertEquals(0, cli.exit(), cli.err());
    assertTrue(cli.out().startsWith("60 boxes"), cli.out());
    assertTrue(cli.out().contains("within 0.0 pixels"), cli.out());
    String[] calibration = row("calibration", "height");
    assertEquals(60, Integer.parseInt(calibration[4]));
    for (int column = 5; column < 8; column++) {
      assertEquals(0.04, Double.parseDouble(calibration[column]), 1e-4, "column " + column);
    }
    assertEquals(wider() * 1.04 * 1.04 - 1, Double.parseDouble(row("calibration", "pip")[7]), 1e-3);
    double flat = Double.parseDouble(row("flat", "height")[7]);
    assertTrue(flat < 0.04 && flat > 0.03, "distances to those beside are longer: " + flat);
    assertEquals(60, table("boxes.csv").size());
    assertTrue(ImageIO.read(folder.resolve("out/reality.png").toFile()).getWidth() > 400);
  }

  @Test
  void matrixOfSameCameraGivesSameTable() throws IOException {
    check("--calibration", xml);
    byte[] tsai = Files.readAllBytes(folder.resolve("out/reality.csv"));
    Cli cli = check("--calibration", matrix, "--image", "1600x1200");
    assertEquals(0, cli.exit(), cli.err());
    assertArrayEquals(tsai, Files.readAllBytes(folder.resolve("out/reality.csv")));
  }

  @Test
  void usesFeetOfBoxesWithoutPositions() throws IOException {
    Files.writeString(boxes, rows(false));
    Cli cli = check("--calibration", xml);
    assertEquals(0, cli.exit(), cli.err());
    assertTrue(cli.out().contains("where boxes stand, by the calibration"), cli.out());
    assertEquals(0.04, Double.parseDouble(row("calibration", "height")[7]), 1e-4);
  }

  @Test
  void omitsAndReportsUncountedAndCutOffBoxes() throws IOException {
    Files.writeString(
        boxes,
        rows(true)
            + "99,1,700,100,50,180,0,0,9,0\n"
            + "99,2,-5,100,50,180,1,0,9,0\n"
            + "99,3,700,100,50,1110,1,0,9,0\n");
    Cli cli = check("--calibration", xml);
    assertTrue(
        cli.out().contains("60 boxes; left out: 1 of confidence 0 or without size, 2 cut off"),
        cli.out());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--calibration XML --unit mm | maybe --unit or --calibration-unit",
        "--calibration XML --calibration-unit m | maybe --unit or --calibration-unit",
        "--calibration MATRIX | expected --image WIDTHxHEIGHT",
        "--calibration MATRIX --image big | --image is 'big', expected pixels such as 1920x1080",
        "--calibration XML --image 640x480 | --image is 640x480, but",
        "--calibration XML --unit px | --unit is px, expected m, cm or mm",
        "--calibration XML --assumed-height 0 | --assumed-height is 0.0, expected a number",
        "--calibration NONE | no such file",
        "--calibration BOXES | expected three rows of four numbers",
        "--calibration OTHER | there is no <Intrinsic>, expected a calibration as the PETS",
        "--calibration WRONG | wrong.xml:3:",
      })
  void rejectsWrongUsageInOneLine(String words, String expected) throws IOException {
    Path other = folder.resolve("other.xml");
    Files.writeString(other, "<Camera><Geometry dpx='1' dpy='1'/></Camera>");
    Path wrong = folder.resolve("wrong.xml");
    Files.writeString(wrong, Files.readString(xml).replace("dpx=\"0.01\"", "dpx=\"wide\""));
    Map<String, Object> paths =
        Map.of(
            "XML",
            xml,
            "MATRIX",
            matrix,
            "BOXES",
            boxes,
            "OTHER",
            other,
            "WRONG",
            wrong,
            "NONE",
            folder.resolve("none.xml"));
    Object[] options =
        Stream.of(words.strip().split(" ")).map(word -> paths.getOrDefault(word, word)).toArray();
    check(options).assertRejected(expected, folder.resolve("out"));
  }

  @Test
  void rejectsRecordingWithAllBoxesAboveHorizon() throws IOException {
    Files.writeString(boxes, "1,1,700,100,50,180,1,-1,-1,-1\n");
    check("--calibration", xml)
        .assertRejected("1 without a place on the ground", folder.resolve("out"));
  }

  private String[] row(String rung, String quantity) throws IOException {
    return table("reality.csv").stream()
        .filter(cells -> cells[0].equals(rung) && cells[1].equals(quantity))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void comparesDetectionsWithDetector() throws IOException {
    List<String> found =
        Files.readAllLines(boxes).stream().filter(row -> !row.contains(",3,")).toList();
    Path detections = Files.write(folder.resolve("det.txt"), found);
    Cli cli =
        check(
            "--calibration",
            xml,
            "--boxes",
            detections,
            "--detections",
            "boxes:frcnn-2016,oodpcvs-2025");
    assertEquals(0, cli.exit(), cli.err());
    double share = found.size() / 60.0;
    assertTrue(
        cli.out().contains(String.format(Locale.ROOT, "detector: %.3f of 60 boxes found", share)),
        cli.out());
    List<String[]> expected = table("expected.csv");
    assertEquals("boxes:frcnn-2016@probability", expected.get(0)[0]);
    assertEquals(share, Double.parseDouble(expected.get(0)[1]), 1e-4);
    double chance = Double.parseDouble(expected.get(0)[2]);
    assertTrue(chance > 0.5 && chance < 1, "expected: " + chance);
    assertEquals("1.0000", expected.get(1)[2], "all are in the picture and near enough");
    assertEquals(12, table("frames.csv").size());
    assertEquals(5, table("people.csv").size());
  }
}
