package org.hificamsim.presentation.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.presentation.replay.Frame;
import org.hificamsim.presentation.replay.RecordedRun;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.runs.cells.FieldCells;
import org.hificamsim.runs.heat.HeatFigure;
import org.hificamsim.runs.heat.HeatMap;
import org.hificamsim.runs.heat.HeatMap.Place;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests pictures of heat maps, on a field of 30 x 20 m with six cells of ten metres. */
class HeatPictureTest {
  /** The width of pictures with one pixel per point. */
  private static final int WIDTH = 800;

  private static final Field FIELD = Hall.FIELD;
  private static final double NONE = Double.NaN;
  private static final Color NEVER = new Color(0xD55E00);

  /** The matrix of an eye that sees all colours. */
  private static final double[] USUAL_EYE = {1, 0, 0, 0, 1, 0, 0, 0, 1};

  private static final boolean[] STAYS = {true, true, true, true};

  /** A map with a cell that no camera covers, one in an obstacle, and four that differ. */
  private static final HeatMap MAP =
      new HeatMap(
          new FieldCells(FIELD, 3, 2),
          List.of(
              new Place(0, 1, 0, 0, 0, NONE, NONE),
              new Place(0.5, 0.5, 0.5, 0, 1, 0, 1),
              new Place(2, 0, 0, 1, 1000, 1.5, 0.25),
              new Place(NONE, NONE, NONE, NONE, 0, NONE, NONE),
              new Place(1, 0, 1, 0, 10, 1, 0),
              new Place(1.7, 0, 0.3, 0.7, 30, 1, 0)));

  @Test
  void cellsHaveColoursOfScale() {
    BufferedImage image = image(HeatFigure.MEAN_K, frames(false, STAYS));
    assertHatched(image, 5.3, 5.2);
    assertSeen(0.25, colorAt(image, 15.3, 5.2));
    assertSeen(1, colorAt(image, 25.3, 5.2));
    assertEquals(Color.WHITE, colorAt(image, 5.3, 15.2), "in an obstacle");
    assertSeen(0.5, colorAt(image, 15.3, 15.2));
  }

  @Test
  void scaleOfVisitsIsLogarithmic() {
    BufferedImage visits = image(HeatFigure.VISITS, frames(false, STAYS));
    assertEquals(Color.WHITE, colorAt(visits, 5.3, 5.2), "nobody was there");
    assertSeen(1 / 3.0, colorAt(visits, 15.3, 15.2));
    BufferedImage covered = image(HeatFigure.VISITS_COVERED, frames(false, STAYS));
    assertSeen(0.75, colorAt(covered, 25.3, 5.2));
    assertHatched(covered, 15.3, 5.2);
  }

  @Test
  void groundIsWhiteToLastRowOfPixels() {
    for (int width = 400; width < 500; width += 7) {
      BufferedImage image =
          FigureFile.image(new HeatPicture(frames(false, STAYS), MAP, HeatFigure.MEAN_K, 1), width);
      assertEquals(0xFFFFFFFF, image.getRGB(1, image.getHeight() - 1), width + " pixels");
    }
  }

  @Test
  void scaleHasFewRoundNumbers() {
    assertEquals(List.of(0.0, 0.25, 0.5, 0.75, 1.0), HeatFigure.MEAN_K.ticks(1));
    assertEquals("0.25 1", HeatFigure.MEAN_K.tick(0.25) + " " + HeatFigure.MEAN_K.tick(1));
    assertEquals(List.of(0.0, 3.0, 6.0, 9.0, 12.0), HeatFigure.MEAN_K.ticks(14));
    assertEquals(List.of(1.0, 10.0, 100.0, 400.0), HeatFigure.VISITS.ticks(400));
    assertEquals(List.of(1.0, 10.0, 120.0), HeatFigure.VISITS.ticks(120));
    assertEquals(List.of(1.0), HeatFigure.VISITS.ticks(1));
    assertEquals("25 %", HeatFigure.COVERED.tick(0.25));
  }

  @Test
  void pictureHasLegendAndSummary() throws IOException {
    ByteArrayOutputStream svg = new ByteArrayOutputStream();
    FigureFile.write(
        svg, "svg", new HeatPicture(frames(false, STAYS), MAP, HeatFigure.COVERED_K, 1));
    String text = svg.toString(StandardCharsets.UTF_8);
    assertTrue(text.contains(HeatFigure.COVERED_K.label()), "label");
    assertTrue(text.contains("never 2 cameras"), "never");
    assertTrue(text.contains(">50 %<"), "ticks");
    assertTrue(text.contains("heat map of 4 steps"), "steps");
    assertTrue(text.contains("of the area 20.0 % never"), "summary");
  }

  /** The matrices of eyes are from Machado, Oliveira and Fernandes, IEEE TVCG 15 (2009). */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "1 0 0 0 1 0 0 0 1",
        "0.152286 1.052583 -0.204868 0.114503 0.786281 0.099216 -0.003882 -0.048116 1.051998",
        "0.367322 0.860646 -0.227968 0.280085 0.672501 0.047413 -0.011820 0.042940 0.968881",
        "1.255528 -0.076749 -0.178779 -0.078411 0.930809 0.147602 0.004733 0.691367 0.303900"
      })
  void coloursDifferForAllEyes(String eye) {
    double[] matrix = Arrays.stream(eye.split(" ")).mapToDouble(Double::parseDouble).toArray();
    List<double[]> colors =
        frames(false, STAYS).script().scale(101).stream().map(color -> lab(color, matrix)).toList();
    for (int i = 0; i <= 100; i++) {
      double[] color = colors.get(i);
      assertTrue(difference(color, lab(NEVER, matrix)) > 20, "never from " + i);
      assertTrue(i == 0 || color[0] > colors.get(i - 1)[0], "lighter");
      assertTrue(i < 20 || difference(color, colors.get(i - 20)) > 10, "20 % of the scale");
    }
  }

  @Test
  void trackIsBrokenWhileTargetIsAbsent() {
    boolean[] away = {true, false, false, true};
    BufferedImage image = image(HeatFigure.VISITS, frames(true, away));
    BufferedImage bare = image(HeatFigure.VISITS, frames(false, away));
    BufferedImage whole = image(HeatFigure.VISITS, frames(true, STAYS));
    assertEquals(
        colorAt(bare, 4, 17), colorAt(image, 4, 17), "between the places where it was seen");
    assertNotEquals(colorAt(bare, 4, 17), colorAt(whole, 4, 17));
    assertNotEquals(colorAt(bare, 2, 17), colorAt(image, 2, 17), "a dot where it appears");
    assertNotEquals(colorAt(bare, 8, 17), colorAt(image, 8, 17), "and where it comes again");
  }

  /** Asserts that there are both the ground and the lines of the hatching within a few metres. */
  private static void assertHatched(BufferedImage image, double x, double y) {
    int palest = 0;
    int darkest = 255;
    for (int i = 0; i < 100; i++) {
      int blue = colorAt(image, x + i % 10 * 0.1, y + i * 0.01).getBlue();
      palest = Math.max(palest, blue);
      darkest = Math.min(darkest, blue);
    }
    assertEquals(255 * (1 - 0.22), palest, 3, "the ground");
    assertTrue(darkest < 130, "a line, whose blue is " + darkest);
  }

  /** Returns a colour of the scale as it looks on white. */
  private static Color seen(double share) {
    return frames(false, STAYS).script().scale(1000).get(Math.min(999, (int) (1000 * share)));
  }

  private static void assertSeen(double share, Color color) {
    double[] wanted = lab(seen(share), USUAL_EYE);
    assertTrue(difference(wanted, lab(color, USUAL_EYE)) < 1, color + " instead of " + seen(share));
  }

  private static double difference(double[] a, double[] b) {
    return Math.sqrt(IntStream.range(0, 3).mapToDouble(i -> Math.pow(a[i] - b[i], 2)).sum());
  }

  /** Returns the CIE L*a*b* values of a colour as an eye sees it (D65). */
  private static double[] lab(Color color, double[] eye) {
    double[] rgb =
        IntStream.of(color.getRed(), color.getGreen(), color.getBlue())
            .mapToDouble(c -> linear(c / 255.0))
            .toArray();
    double[] s = product(eye, rgb);
    double[] xyz =
        product(new double[] {.4124, .3576, .1805, .2126, .7152, .0722, .0193, .1192, .9505}, s);
    double x = root(xyz[0] / .9505);
    double y = root(xyz[1]);
    double z = root(xyz[2] / 1.089);
    return new double[] {116 * y - 16, 500 * (x - y), 200 * (y - z)};
  }

  private static double[] product(double[] matrix, double[] v) {
    return IntStream.range(0, 3)
        .mapToDouble(
            i -> matrix[3 * i] * v[0] + matrix[3 * i + 1] * v[1] + matrix[3 * i + 2] * v[2])
        .map(sum -> Math.max(0, Math.min(1, sum)))
        .toArray();
  }

  private static double linear(double c) {
    return c <= 0.04045 ? c / 12.92 : Math.pow((c + 0.055) / 1.055, 2.4);
  }

  private static double root(double t) {
    return t > 0.008856 ? Math.cbrt(t) : 7.787 * t + 16.0 / 116;
  }

  private static RunFrames frames(boolean tracks, boolean... present) {
    Setup setup =
        Hall.setup(
            List.of(),
            List.of(new Setup.Target("a", 0.5)),
            List.of(),
            List.of(),
            List.of(),
            List.of());
    List<Frame> frames = new ArrayList<>();
    for (int step = 0; step < 4; step++) {
      frames.add(frame(step, present[step]));
    }
    RecordedRun recording = new RecordedRun(0, 0, 4, 1, "", List.of(), frames);
    return new RunFrames(
        setup, recording, new Look(0.5, OptionalInt.empty(), tracks), Optional.empty());
  }

  /** Returns a frame of a target that goes east, two metres a step. */
  private static Frame frame(int step, boolean present) {
    return Hall.frame(step, new int[0], present, new double[] {2 + 2 * step}, new double[] {17});
  }

  private static BufferedImage image(HeatFigure figure, RunFrames frames) {
    return FigureFile.image(new HeatPicture(frames, MAP, figure, 1), WIDTH);
  }

  private static Color colorAt(BufferedImage image, double x, double y) {
    return new Places(FIELD).color(image, x, y);
  }
}
