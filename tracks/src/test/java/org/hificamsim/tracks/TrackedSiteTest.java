package org.hificamsim.tracks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.tracks.place.DraftCameras;
import org.hificamsim.tracks.place.PeoplePositions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the scenario around imported tracks, and its draft cameras. */
class TrackedSiteTest {
  private static final Field FIELD = new Field(10, 110, -20, 30);

  @TempDir Path folder;

  @Test
  void addsMarginAroundSamples() {
    assertEquals(new Field(-3, 33, -4, 8), site("0 1 0.5 -0.5\n1 1 30 5\n", 0, 0).field());
    assertEquals(new Field(-1, 3, 0, 6), site("0 1 0.5 1.5\n1 1 1.5 4.5\n", 0, 0).field());
    assertEquals(new Field(-5, 7, -4, 10), site("0 1 0.5 1.5\n1 1 1.5 4.5\n", 5, 0).field());
  }

  @Test
  void coversTimeFromFirstToLastSample() {
    String recording = "0 1 0 0\n1 1 1 0\n2 1 2 0\n3 1 3 0\n";
    TrackedSite asRecorded = site(recording, 0, 0);
    assertEquals(0.4, asRecorded.step());
    assertEquals(4, asRecorded.steps());
    TrackedSite coarse = site(recording, 0, 0.5);
    assertEquals(0.5, coarse.step());
    assertEquals(3, coarse.steps());
    assertEquals(
        "question: covered:k=1 by oodpcvs-2025:level=discern in 3 steps", coarse.question());
  }

  @Test
  void writesScenarioWithItsSource() throws IOException {
    TrackedSite site = site("0 1 0 0\n1 1 10 4\n", 0, 0);
    String xml = site.xml("a.tracks");
    assertTrue(xml.contains("<!-- Made by hificamsim import of a- -b$1.txt -->\n<root>"), xml);
    Path file = Files.writeString(folder.resolve("a.xml"), xml);
    Files.copy(folder.resolve("made.tracks"), folder.resolve("a.tracks"));
    Scenario read = ScenarioReader.read(file, movement -> true, warning -> {});
    assertEquals(site.field(), read.field());
    assertEquals(3, read.get(Scenario.CAMERAS).size());
    assertEquals(2, read.get(Scenario.STEPS));
    assertEquals(0.4, read.get(Scenario.STEP_TIME));
    assertEquals(List.of(new Obstacle.Wall(0, 1, 2, 1, 0)), read.get(Scenario.OBSTACLES));
  }

  /** Imports a recording at 2.5 samples per second; 0 stands for settings that are not given. */
  private TrackedSite site(String recording, double margin, double step) {
    SiteSettings settings =
        new SiteSettings(
            "place",
            Path.of("in/a--b$1.txt"),
            3,
            margin == 0 ? OptionalDouble.empty() : OptionalDouble.of(margin),
            step == 0 ? OptionalDouble.empty() : OptionalDouble.of(step),
            List.of(new Obstacle.Wall(0, 1, 2, 1, 0)),
            Optional.empty());
    return new TrackedSite(settings, new Imported(folder).rate(2.5).read("ethucy", recording));
  }

  @Test
  void placesCamerasAtEqualDistances() {
    assertEquals(
        List.of(
            new Point(10.5, -19.5),
            new Point(47.5, -19.5),
            new Point(84.5, -19.5),
            new Point(109.5, -7.5),
            new Point(109.5, 29.5),
            new Point(72.5, 29.5),
            new Point(35.5, 29.5),
            new Point(10.5, 17.5)),
        positions(8));
  }

  @Test
  void movesCamerasOutOfWalls() {
    Obstacle corner = new Obstacle.Pillar(10, -20, 3, 0);
    Obstacle left =
        new Obstacle.Polygon(
            List.of(new Point(9, -15), new Point(12, -15), new Point(12, 28), new Point(9, 28)), 0);
    List<Point> positions = positions(8, corner, left);
    assertEquals(new Point(13.46, -19.5), positions.get(0)); // the fourth of 400 parts of 296 m
    assertEquals(new Point(10.5, -15.06), positions.get(7)); // at 37 m and 44 parts
    Obstacle large = new Obstacle.Pillar(10, 0, 25, 0);
    assertEquals(
        new Point(26.04, -19.5), positions(8, large).get(7)); // around the corner, 71 parts
  }

  private static List<Point> positions(int count, Obstacle... obstacles) {
    return new DraftCameras(
            FIELD, new Obstacles(List.of(obstacles)), new PeoplePositions(), count, 80)
        .cameras().stream().map(camera -> new Point(camera.x(), camera.y())).toList();
  }
}
