package org.hificamsim.presentation.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import javax.imageio.ImageIO;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.presentation.replay.CameraPose;
import org.hificamsim.presentation.replay.CameraPose.Interval;
import org.hificamsim.presentation.replay.CameraPose.Level;
import org.hificamsim.presentation.replay.CameraPose.LevelOptics;
import org.hificamsim.presentation.replay.Frame;
import org.hificamsim.presentation.replay.RecordedRun;
import org.hificamsim.presentation.replay.Setup;
import org.junit.jupiter.api.Test;

/** Tests pictures of a camera at (5, 10) that looks east, with a wall at x = 10 in its way. */
class SitePictureTest {
  /** The width of pictures with one pixel per point. */
  private static final int WIDTH = 800;

  private static final Field FIELD = Hall.FIELD;
  private static final Obstacle WALL = new Obstacle.Wall(10, 8, 10, 12, 0);

  /** The area on both sides of the wall, but not behind it. */
  private static final List<Double> VISIBLE =
      List.of(5.0, 10.0, 30.0, -10.0, 30.0, 0.0, 10.0, 8.0, 10.0, 12.0, 30.0, 20.0, 30.0, 30.0);

  private static final Color LIT = new Color(222, 237, 245);
  private static final Color NO_CAMERA = new Color(0xD55E00);
  private static final Color WALL_COLOR = new Color(0x1D2733);

  @Test
  void areaHiddenByWallIsHatched() {
    BufferedImage image = image(setup(List.of(WALL), VISIBLE, List.of()), 1, Look.DEFAULT);
    assertEquals(LIT, colorAt(image, 8.3, 10.2));
    assertShadow(image, 12.3, 10.2);
    assertEquals(Color.WHITE, colorAt(image, 2.3, 10.2), "behind the camera");
    assertEquals(WALL_COLOR, colorAt(image, 10, 9.2));
  }

  @Test
  void hatchingEndsAtBorderOfField() {
    BufferedImage image = image(setup(30, List.of(WALL), VISIBLE, List.of()), 1, Look.DEFAULT);
    assertShadow(image, 28.3, 10.2);
    for (double x = 30.3; x < 31.5; x += 0.1) {
      assertEquals(Color.WHITE, colorAt(image, x, 10.2), "at x = " + x);
    }
  }

  /** Asserts that there are both the ground and the lines of the hatching within a metre. */
  private static void assertShadow(BufferedImage image, double x, double y) {
    int palest = 0;
    int darkest = 255;
    for (int i = 0; i < 100; i++) {
      int green = colorAt(image, x + i % 10 * 0.1, y + i * 0.01).getGreen();
      palest = Math.max(palest, green);
      darkest = Math.min(darkest, green);
    }
    assertTrue(palest > 200 && palest < 225 && darkest < 180, darkest + " to " + palest);
  }

  @Test
  void cameraThatTurnsHasNoDetectionRange() {
    BufferedImage image = image(setup(List.of(WALL), VISIBLE, List.of()), -1, Look.DEFAULT);
    assertEquals(Color.WHITE, colorAt(image, 8.3, 10.2));
    assertEquals(Color.WHITE, colorAt(image, 12.3, 10.2));
  }

  @Test
  void viewIsTurnedByItsPan() {
    BufferedImage image = image(setup(List.of(), List.of(), List.of()), 0, Look.DEFAULT);
    assertEquals(Color.WHITE, colorAt(image, 8.3, 10.2));
    assertEquals(LIT, colorAt(image, 5.3, 14.2), "a quarter to the left");
  }

  @Test
  void transparentObstaclesArePaler() {
    Obstacle solid = new Obstacle.Pillar(20, 16, 1.5, 0);
    Obstacle pale = new Obstacle.Pillar(25, 16, 1.5, 0.3);
    BufferedImage image = image(setup(List.of(solid, pale), List.of(), List.of()), 0, Look.DEFAULT);
    int dark = colorAt(image, 20.3, 16.3).getGreen();
    int light = colorAt(image, 25.3, 16.3).getGreen();
    assertTrue(dark < light - 60 && light < 250, dark + " and " + light);
  }

  @Test
  void chosenCameraHasDensityZones() {
    Setup setup = setup(List.of(), List.of(), List.of());
    BufferedImage image = image(setup, 1, new Look(0.5, OptionalInt.of(0), false));
    Color characterise = colorAt(image, 6.3, 10.4); // 500 px/m at a metre: characterise to 2 m
    Color perceive = colorAt(image, 8.3, 10.9); // to 4 m
    Color discern = colorAt(image, 10.3, 10.9); // to 6.25 m
    Color outline = colorAt(image, 14.3, 10.9); // to 12.5 m
    Color overview = colorAt(image, 22.3, 10.9); // to 25 m
    assertTrue(characterise.getGreen() < perceive.getGreen(), characterise + " " + perceive);
    assertTrue(perceive.getGreen() < discern.getGreen(), perceive + " " + discern);
    assertTrue(discern.getGreen() < outline.getGreen(), discern + " " + outline);
    assertTrue(outline.getGreen() < overview.getGreen(), outline + " " + overview);
    assertEquals(Color.WHITE, colorAt(image, 31.3, 10.2));
  }

  @Test
  void floorPlanHasOpacityOfLook() throws IOException {
    Setup setup = setup(List.of(), List.of(), List.of(floor()));
    Color half = colorAt(image(setup, 1, Look.DEFAULT), 20.3, 17.3);
    assertEquals(255, half.getRed());
    assertEquals(127.5, half.getGreen(), 1);
    Look opaqueFloor = new Look(1, OptionalInt.empty(), false);
    assertEquals(Color.RED, colorAt(image(setup, 1, opaqueFloor), 20.3, 17.3));
    assertEquals(Color.WHITE, colorAt(image(setup, 1, opaqueFloor), 20.3, 3.3), "outside the plan");
    ByteArrayOutputStream svg = new ByteArrayOutputStream();
    FigureFile.write(svg, "svg", new StepPicture(frames(setup, 1, opaqueFloor), 0));
    assertTrue(svg.toString(StandardCharsets.UTF_8).contains("xlink:href=\"data:image/png;base64"));
  }

  @Test
  void widerTargetsAreLarger() {
    Setup setup = setup(List.of(), List.of(), List.of());
    RunFrames frames = frames(setup, 1, Look.DEFAULT, true);
    BufferedImage image = FigureFile.image(new StepPicture(frames, 0), WIDTH);
    double offset = 12 / new Places(FIELD).scale(); // 12 points to the right and up
    assertNotEquals(NO_CAMERA, colorAt(image, 13 + offset, 2 + offset));
    assertEquals(NO_CAMERA, colorAt(image, 20 + offset, 2 + offset));
  }

  private static Setup.Floor floor() throws IOException {
    BufferedImage red = new BufferedImage(4, 4, BufferedImage.TYPE_INT_RGB);
    red.createGraphics().fillRect(0, 0, 4, 4);
    for (int i = 0; i < 16; i++) {
      red.setRGB(i % 4, i / 4, 0xFF0000);
    }
    ByteArrayOutputStream png = new ByteArrayOutputStream();
    ImageIO.write(red, "png", png);
    String data = Base64.getEncoder().encodeToString(png.toByteArray());
    return new Setup.Floor(new Field(0, 30, 10, 20), "data:image/png;base64," + data);
  }

  private static Setup setup(
      List<Obstacle> obstacles, List<Double> visible, List<Setup.Floor> floor) {
    return setup(10, obstacles, visible, floor);
  }

  private static Setup setup(
      double reach, List<Obstacle> obstacles, List<Double> visible, List<Setup.Floor> floor) {
    Level level = new Level(30, List.of(new Interval(0, reach)));
    CameraPose pose =
        new CameraPose(
            5,
            10,
            Math.PI / 2,
            Math.PI / 3,
            List.of(level),
            List.of(-Math.PI / 2, 0.0),
            List.of(),
            List.of(new LevelOptics(Math.PI / 3, 500)),
            visible,
            List.of());
    return Hall.setup(
        List.of(new Setup.Camera("cam", pose)),
        List.of(new Setup.Target("a", 0.5), new Setup.Target("b", 0.5)),
        List.of(0.5, 2.0),
        List.of(0),
        obstacles,
        floor);
  }

  private static RunFrames frames(Setup setup, int seeing, Look look) {
    return frames(setup, seeing, look, false);
  }

  private static RunFrames frames(Setup setup, int seeing, Look look, boolean present) {
    Frame frame =
        Hall.frame(0, new int[] {seeing}, present, new double[] {13, 20}, new double[] {2, 2});
    return new RunFrames(
        setup, new RecordedRun(0, 0, 1, 1, "", List.of(), List.of(frame)), look, Optional.empty());
  }

  private static BufferedImage image(Setup setup, int seeing, Look look) {
    return FigureFile.image(new StepPicture(frames(setup, seeing, look), 0), WIDTH);
  }

  private static Color colorAt(BufferedImage image, double x, double y) {
    return new Places(FIELD).color(image, x, y);
  }
}
