package org.hificamsim.presentation.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageInputStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.world.World;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.presentation.replay.Frame;
import org.hificamsim.presentation.replay.Replay;
import org.hificamsim.presentation.replay.ReplayRecorder;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.output.ResultFolder;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests pictures and animations of recorded steps. */
class StepPictureTest {
  /** The width of pictures with one pixel per point. */
  private static final int WIDTH = 800;

  private static final Color[] COVER = {
    new Color(0xD55E00), new Color(0xE69F00), new Color(0x56B4E9), new Color(0x009E73)
  };
  private static RunFrames run;

  @BeforeAll
  static void record(@TempDir Path folder) throws IOException {
    Path file =
        Path.of(System.getProperty("hificamsim.root", "."), "scenarios", "cluster-random.xml");
    run = recorded(ScenarioReader.read(file, movement -> true, warning -> {}), 300, folder);
  }

  private static RunFrames recorded(Scenario scenario, int steps, Path folder) throws IOException {
    Catalogue catalogue = Catalogue.load();
    RunPlan plan =
        new RunPlan(
            scenario,
            Detection.of(catalogue.detection("hifi:orb-lin")),
            "epsilon-greedy",
            steps,
            0,
            1);
    World world = new World(plan.scenario(), catalogue.movements(), 0);
    Setup setup = Setup.of(world, plan.detection(), plan.policy(), 0, List.of());
    ReplayRecorder recorder = new ReplayRecorder(setup, plan.detection(), 1);
    new RunExecutor(catalogue).execute(plan, i -> List.of(recorder.listener(i)));
    try (OutputStream out = Files.newOutputStream(folder.resolve(ResultFolder.REPLAY))) {
      recorder.write(out);
    }
    Replay replay = Replay.read(folder);
    return new RunFrames(replay.setup(), replay.recording(folder, 0));
  }

  @Test
  void namesPolicyAndDetectionInWords() {
    String settings = StepPicture.settings(run.setup(), 3);
    assertTrue(settings.endsWith(", ORB linear with threshold 0.0441, seed 3"), settings);
  }

  @Test
  void trailsFarOutsideAreLeftOut(@TempDir Path folder) throws IOException {
    RunFrames far =
        recorded(
            ScenarioReader.read(
                Files.writeString(folder.resolve("far.xml"), FAR), movement -> true, warning -> {}),
            30,
            folder);
    ByteArrayOutputStream svg = new ByteArrayOutputStream();
    FigureFile.write(svg, "svg", new StepPicture(far, 29));
    Matcher ends =
        Pattern.compile("<line[^>]*>")
            .matcher(svg.toString(java.nio.charset.StandardCharsets.UTF_8));
    int lines = 0;
    while (ends.find()) {
      lines++;
      Pattern.compile("\\b[xy][12]=\"([^\"]*)\"")
          .matcher(ends.group())
          .results()
          .forEach(
              end -> assertTrue(Math.abs(Double.parseDouble(end.group(1))) < 4000, ends.group()));
    }
    assertTrue(lines > 10, lines + " lines");
  }

  /** A target that moves a hundred thousand kilometres in each step, and one that passes by. */
  private static final String FAR =
      """
      <root><simulation min_x="-10" max_x="10" min_y="-10" max_y="10"><cameras><zoom>2 4</zoom>
      <camera name="A" x="0" y="0" heading="0" viewing_angle="60" range="4"/></cameras><objects>
      <object_with_waypoints features="0.1" speed="100000000"><waypoint x="-1000000000" y="3"/>
      <waypoint x="1000000000" y="5"/></object_with_waypoints></objects></simulation></root>
      """;

  @Test
  void targetsHaveColourOfTheirCoverage() {
    Set<Integer> seen = new HashSet<>();
    for (int step = 0; step < 300; step += 7) {
      BufferedImage image = FigureFile.image(new StepPicture(run, step), WIDTH);
      Frame frame = run.frame(step);
      Places map = new Places(run.setup().field());
      for (int target = 0; target < frame.x().length; target++) {
        if (alone(frame, target, map)) {
          int cover = Math.min(3, frame.coverage()[target]);
          int x = (int) map.x(frame.x()[target]);
          int y = (int) map.y(frame.y()[target]);
          boolean painted = false;
          for (int down = -6; down <= 6; down++) {
            painted |= image.getRGB(x, y + down) == COVER[cover].getRGB();
          }
          assertTrue(painted, "step " + step + ", target " + target + ", " + cover);
          seen.add(cover);
        }
      }
    }
    assertTrue(seen.contains(0) && seen.contains(3), seen.toString());
  }

  private static boolean alone(Frame frame, int target, Places map) {
    for (int other = 0; other < frame.x().length; other++) {
      double gap =
          Math.hypot(frame.x()[other] - frame.x()[target], frame.y()[other] - frame.y()[target]);
      if (other != target && gap * map.scale() < 20) {
        return false;
      }
    }
    return true;
  }

  @Test
  void animationShowsPicturesAndRepeatsForEver() throws IOException {
    Animation animation = new Animation(run, 100, 130, 7);
    assertEquals(6, animation.pictures()); // 100, 107, ..., 128, 130
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    animation.write(out, 400, 20);
    ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
    try (ImageInputStream in =
        ImageIO.createImageInputStream(new ByteArrayInputStream(out.toByteArray()))) {
      reader.setInput(in);
      assertEquals(6, reader.getNumImages(true));
      BufferedImage shown = null;
      for (int i = 0; i < 6; i++) {
        BufferedImage wanted =
            FigureFile.image(new StepPicture(run, Math.min(130, 100 + 7 * i)), 400);
        if (shown == null) {
          shown = new BufferedImage(400, wanted.getHeight(), BufferedImage.TYPE_INT_RGB);
        }
        Graphics2D graphics = shown.createGraphics();
        graphics.drawImage(reader.read(i), 0, 0, null);
        graphics.dispose();
        assertTrue(meanGap(wanted, shown) < 2, "picture " + i);
        assertEquals("5", node(reader, i, "GraphicControlExtension").getAttribute("delayTime"));
      }
      IIOMetadataNode loop = node(reader, 0, "ApplicationExtension");
      assertEquals("NETSCAPE", loop.getAttribute("applicationID"));
    }
  }

  private static IIOMetadataNode node(ImageReader reader, int image, String name)
      throws IOException {
    IIOMetadataNode root =
        (IIOMetadataNode) reader.getImageMetadata(image).getAsTree("javax_imageio_gif_image_1.0");
    return (IIOMetadataNode) root.getElementsByTagName(name).item(0);
  }

  /** The mean difference of the green parts, of 255. */
  private static double meanGap(BufferedImage a, BufferedImage b) {
    long sum = 0;
    for (int y = 0; y < a.getHeight(); y++) {
      for (int x = 0; x < a.getWidth(); x++) {
        sum += Math.abs((a.getRGB(x, y) >> 8 & 255) - (b.getRGB(x, y) >> 8 & 255));
      }
    }
    return (double) sum / a.getWidth() / a.getHeight();
  }

  @Test
  void longAnimationLeavesOutSteps() {
    Animation animation = Animation.of(run, 0, 299);
    assertEquals(2, animation.stepsApart());
    assertEquals(151, animation.pictures());
  }

  @Test
  void rejectsStepThatWasNotRecorded() {
    assertEquals(299, run.indexOf("--step", 299));
    String message =
        assertThrows(InputException.class, () -> run.indexOf("--step", 300)).getMessage();
    assertEquals("--step is 300, expected a step from 0 to 299", message);
    assertThrows(InputException.class, () -> run.indexOf("--step", -1));
  }
}
