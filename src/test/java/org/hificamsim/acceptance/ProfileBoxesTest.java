package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests {@code profile boxes}: from a labelled recording to a run with its model. */
class ProfileBoxesTest {
  @TempDir private Path folder;

  private Path labels;
  private Path detections;

  /**
   * Writes labels of people who cross the picture, and detections of them.
   *
   * @param findsByChance whether the detector finds people with equal chance, or else large ones
   *     more often
   */
  private void record(boolean findsByChance) throws IOException {
    Random random = new Random(56);
    StringBuilder gt = new StringBuilder();
    StringBuilder det = new StringBuilder();
    for (int frame = 1; frame <= 60; frame++) {
      for (int person = 1; person <= 16; person++) {
        int height = 30 + 12 * person;
        int left = (40 * person + (person % 2 == 0 ? 6 : -6) * frame + 720) % 720;
        String box = left + "," + (400 - 300 / person) + "," + height / 3 + "," + height;
        gt.append(frame).append(',').append(person).append(',').append(box).append(",1\n");
        double chance = findsByChance ? 0.6 : height / 200.0;
        if (random.nextDouble() < chance) {
          det.append(frame).append(",-1,").append(box).append(",0.9\n");
        }
      }
    }
    labels = Files.writeString(folder.resolve("street.gt.txt"), gt);
    detections = Files.writeString(folder.resolve("street.det.txt"), det);
  }

  private static Cli assertDone(Cli command) {
    assertEquals(0, command.exit(), command.err());
    return command;
  }

  @Test
  void fitsChecksAndRunsOneModel() throws IOException {
    record(false);
    Path out = folder.resolve("out");
    Cli fitted =
        assertDone(
            Cli.run(
                "profile",
                "boxes",
                labels,
                detections,
                "--out",
                out,
                "--name",
                "street",
                "--image",
                "720x600"));
    assertTrue(fitted.out().contains("street: 960 boxes of 16 people in 60 frames"), fitted.out());
    assertTrue(Files.exists(out.resolve("found.png")));
    assertEquals(961, Files.readAllLines(out.resolve("boxes.csv")).size());
    Path model = out.resolve("models/street.json");
    try (Stream<Path> models = Files.list(out.resolve("models"))) {
      assertEquals(List.of(model), models.toList());
    }
    Cli checked = assertDone(Cli.run("profile", "boxes", labels, detections, "--model", model));
    List<String> lines = checked.out().lines().toList();
    assertTrue(lines.get(0).matches("measured 0\\.\\d{3}"), checked.out());
    assertTrue(lines.get(1).matches("expected 0\\.\\d{3}"), checked.out());
    assertTrue(lines.get(2).matches("log loss 0\\.\\d{3}"), checked.out());
    String rest = String.join("\n", lines.subList(3, lines.size()));
    assertFalse(rest.matches("(?s).*(measured|expected|log loss).*"), rest);
    Cli run =
        assertDone(
            Cli.run(
                "run",
                "scenarios/ring-random.xml",
                "--steps",
                20,
                "--detection",
                model,
                "--out",
                folder.resolve("run")));
    assertTrue(run.out().contains("street@probability"), run.out());
  }

  @Test
  void secondFitLeavesOneModel() throws IOException {
    record(false);
    Path out = folder.resolve("out");
    for (String name : List.of("first", "second")) {
      assertDone(Cli.run("profile", "boxes", labels, detections, "--out", out, "--name", name));
    }
    try (Stream<Path> models = Files.list(out.resolve("models"))) {
      assertEquals(List.of(out.resolve("models/second.json")), models.toList());
    }
  }

  @Test
  void ignoresOcclusionWhenPlacingCameras() throws IOException {
    Cli placed =
        assertDone(
            Cli.run(
                "place",
                "scenarios/corridor.xml",
                "--cameras",
                2,
                "--detection",
                "boxes:frcnn-2016",
                "--out",
                folder.resolve("plan")));
    assertTrue(
        placed.out().contains("boxes:frcnn-2016: people are seen from a probability of 0.5 on"),
        placed.out());
  }

  @Test
  void rejectsDetectorThatFindsByChance() throws IOException {
    record(true);
    Path out = folder.resolve("out");
    Cli refused = Cli.run("profile", "boxes", labels, detections, "--out", out, "--name", "random");
    assertEquals(2, refused.exit());
    assertTrue(refused.err().contains("random is no detector"), refused.err());
    assertFalse(Files.exists(out.resolve("models/random.json")));
    assertTrue(Files.exists(out.resolve("boxes.csv")), "what was measured is kept");
  }

  @Test
  void rejectsInvalidArguments() throws IOException {
    record(false);
    assertRejected("pairs", "profile", "boxes", labels, detections, labels);
    assertRejected("--overlap", "profile", "boxes", labels, detections, "--overlap", 2);
    assertRejected(
        "expected a model that profile boxes",
        "profile",
        "boxes",
        labels,
        detections,
        "--model",
        "hifi:orb-lin");
  }

  private static void assertRejected(String expected, Object... words) {
    Cli refused = Cli.run(words);
    assertEquals(2, refused.exit(), refused.out());
    assertTrue(refused.err().contains(expected), refused.err());
  }
}
