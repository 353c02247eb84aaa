package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the warnings about scenarios that do not suit a detection model. */
class DetectionHintsTest {

  @TempDir Path folder;

  @Test
  void compareExplainsZeroCoverage() throws IOException {
    Cli compare = compare(carPark(20));
    assertEquals(0, compare.exit(), compare.err());
    assertTrue(compare.out().contains("no step had every target covered"), compare.out());
    assertTrue(compare.out().contains("covered by none [95%]"), compare.out());
    assertTrue(compare.out().contains("mean k [95%]"), compare.out());
    assertTrue(compare.out().contains("car-park, hifi:orb-lin: detected up to "), compare.out());
    assertTrue(compare.out().contains("car-park, camsim-range: detected up to "), compare.out());
  }

  @Test
  void compareExplainsNothingIfSomethingIsCovered() {
    Cli compare = compare(Cli.scenario("ring-random"));
    assertEquals(0, compare.exit(), compare.err());
    assertFalse(compare.out().contains("detected up to"), compare.out());
  }

  @Test
  void runExplainsZeroCoverage() throws IOException {
    Cli run = Cli.run("run", carPark(20), "--steps", 5, "--out", folder.resolve("out"));
    assertEquals(0, run.exit(), run.err());
    assertTrue(run.out().contains("detected up to   "), run.out());
    assertTrue(run.out().contains(" of 20, "), run.out());
    Cli covered =
        Cli.run("run", Cli.scenario("ring-random"), "--steps", 50, "--out", folder.resolve("r"));
    assertFalse(covered.out().contains("detected up to"), covered.out());
  }

  /** The targets stand 114 m from the nearer camera. */
  @Test
  void warnsOfShortReachAndNamesAlternative() throws IOException {
    Path file = carPark(60);
    String start = "warning: " + file + ": 'hifi:orb-lin' detects up to ";
    String end =
        "none of the targets come so near to a camera in 100 steps (half of them no nearer than 114"
            + " m): hardly anything is covered; expected another model, such as oodpcvs-2025, which"
            + " reaches 120 m";
    Path out = folder.resolve("out");
    for (Cli cli :
        List.of(
            Cli.run("validate", file),
            Cli.run("run", file, "--steps", 5, "--out", out),
            compare(file))) {
      assertEquals(0, cli.exit(), cli.err());
      assertTrue(
          cli.err().lines().anyMatch(line -> line.startsWith(start) && line.endsWith(end)),
          cli.err());
    }
    assertEquals("", Cli.run("validate", file, "--detection", "geometric").err());
    assertEquals(2, Cli.run("validate", file, "--strict").exit());
    assertTrue(
        Cli.run("validate", carPark(2.5)).err().contains("longer focal lengths, larger radii"));
  }

  @Test
  void compareWarnsOfEachDetection() {
    Cli run =
        Cli.run(
            "compare",
            Cli.scenario("campus"),
            "--steps",
            1,
            "--policies",
            "zoom-out",
            "--out",
            folder.resolve("c"),
            "--detections",
            "camsim-range,geometric");
    assertTrue(run.err().contains("'camsim-range' detects up to 0.0"), run.err());
    assertFalse(run.err().contains("'geometric' detects"), run.err());
  }

  @Test
  void warnsOfThresholdThatReplacesTheModels() throws IOException {
    String text = Files.readString(Cli.scenario("ring-random"));
    Path file = folder.resolve("ring.xml");
    Files.writeString(file, text.replaceFirst("<simulation ", "<simulation threshold=\"0.04\" "));
    String warning =
        "warning: "
            + file
            + ": its threshold 0.04 is used for 'hifi:orb-lin', whose own is 0.0441; expected"
            + " detection hifi:orb-lin@0.0441 where that one is meant";
    assertEquals(warning, Cli.run("validate", file).err().strip());
    Path out = folder.resolve("out");
    assertEquals(warning, Cli.run("run", file, "--steps", 1, "--out", out).err().strip());
    String own = "hifi:orb-lin@0.0441";
    assertEquals("", Cli.run("run", file, "--steps", 1, "--detection", own, "--out", out).err());
  }

  @Test
  void warnsOfSizesOutsideFittedRange() throws IOException {
    Path file = folder.resolve("large.xml");
    String text = Files.readString(Cli.scenario("ring-random"));
    Files.writeString(file, text.replaceAll("size=\"[0-9.]+\"", "size=\"0.9\""));
    String err = Cli.run("validate", file).err();
    assertTrue(
        err.contains(
            "'hifi:orb-lin' was not fitted on what is asked of it: sizes 0.9 m (fitted on"),
        err);
  }

  @Test
  void warnsOfUnstatedOrderOfSteps() throws IOException {
    Path file = folder.resolve("hall.xml");
    String text = Files.readString(Cli.scenario("hall"));
    Files.writeString(file, text.replace(" order=\"coverage\"", ""));
    String err = Cli.run("validate", file, "--detection", "dori-2014").err();
    assertTrue(err.contains("neither <zoom> nor order runs in CamSim's order"), err);
    assertEquals("", Cli.run("validate", Cli.scenario("hall"), "--detection", "dori-2014").err());
  }

  @Test
  void warnsOfContradictoryViewingAngle() throws IOException {
    Path file = Cli.scenario("tutorial-two-cameras");
    String warning =
        "warning: "
            + file
            + ": camera 'East' sees 120 degrees (viewing_angle), but its focal length gives 15 to"
            + " 43.1 (Eq 3.1); expected a mount_height that makes them agree, such as 4.33, or"
            + " viewing_angle 360";
    assertEquals(warning, first(Cli.run("validate", file)));
    Path out = folder.resolve("out");
    assertEquals(warning, first(Cli.run("run", file, "--steps", 5, "--out", out)));
    assertEquals(2, Cli.run("run", file, "--steps", 5, "--out", out, "--strict").exit());
    Cli plain =
        Cli.run("run", file, "--steps", 5, "--out", out, "--detection", "camsim-range@0.35");
    assertEquals("", plain.err());
  }

  @Test
  void proposedHeightEndsTheWarning() throws IOException {
    String text = Files.readString(Cli.scenario("tutorial-two-cameras"));
    Path file = folder.resolve("lower.xml");
    Files.writeString(file, text.replace("mount_height=\"19\"", "mount_height=\"4.33\""));
    assertFalse(
        Cli.run("validate", file, "--detection", "hifi:orb-power").err().contains("(Eq 3.1)"));
  }

  @Test
  void warnsOfCameraThatSeesNoTarget() throws IOException {
    Path site = Cli.scenario("warehouse-heights");
    assertEquals("", Cli.run("validate", site).err());
    Path file = folder.resolve("up.xml");
    Files.writeString(
        file,
        Files.readString(site)
            .replace("tilt=\"0 8\"", "tilt=\"0\"")
            .replace("<camera name=\"dock-north\"", "<camera tilt=\"-60\" name=\"dock-north\""));
    String warning = first(Cli.run("validate", file));
    String start =
        "warning: " + file + ": no target can be seen anywhere by camera 'dock-north' at";
    assertTrue(warning.startsWith(start + " hfov 11 tilt -60, "), warning);
    assertFalse(warning.contains("dock-south"), warning);
  }

  @Test
  void summaryHasTheLens() throws IOException {
    Path out = folder.resolve("out");
    Cli.run("run", Cli.scenario("ring-random"), "--steps", 5, "--out", out);
    JsonNode settings = new ObjectMapper().readTree(out.resolve("summary.json").toFile());
    assertEquals(2 * 0.085 * 2.5 / 0.0224, settings.get("mount_height").asDouble(), 1e-12);
    assertEquals(5, settings.get("focal_lengths").size());
    assertEquals(0.085, settings.get("focal_lengths").get(0).asDouble());
    assertEquals(0.085 / 3, settings.get("focal_lengths").get(4).asDouble(), 1e-15);
  }

  @Test
  void summaryHasNoLensForModelWithoutOne() throws IOException {
    Path out = folder.resolve("out");
    Cli.run(
        "run", Cli.scenario("ring-random"), "--detection", "geometric", "--steps", 5, "--out", out);
    JsonNode settings = new ObjectMapper().readTree(out.resolve("summary.json").toFile());
    assertTrue(settings.get("mount_height").isNull());
    assertEquals(0, settings.get("focal_lengths").size());
  }

  private static String first(Cli run) {
    return run.err().lines().findFirst().orElse("");
  }

  private Cli compare(Path file) {
    Object[] words = {"compare", file, "--steps", 20, "--repeat", 2, "--out", folder.resolve("c")};
    return Cli.run(words);
  }

  /**
   * Writes a scenario of two cameras and two targets far apart, with radii of 1, 1.5 and 2 times
   * the first.
   */
  private Path carPark(double radius) throws IOException {
    String zooms = radius + " " + 1.5 * radius + " " + 2 * radius;
    String text =
        """
        <root><simulation min_x="0" max_x="200" min_y="0" max_y="120"><zoom>%s</zoom>
        <camera name="a" x="10" y="60" heading="0" viewing_angle="360" range="9"/>
        <camera name="b" x="90" y="60" heading="0" viewing_angle="360" range="9"/>
        <object features="1" x="190" y="5" heading="0" speed="0"/>
        <object features="2" x="190" y="115" heading="0" speed="0"/>
        </simulation></root>
        """
            .formatted(zooms);
    return Files.writeString(folder.resolve("car-park.xml"), text);
  }
}
