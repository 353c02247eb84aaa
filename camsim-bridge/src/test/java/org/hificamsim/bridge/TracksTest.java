package org.hificamsim.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.scenario.Scenario;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests recorded tracks in CamSim, where objects come and go by events and the bridge moves them.
 */
class TracksTest {
  private static final int STEPS = 30;
  private static final String CAMERAS =
      """
      <camera name="A" x="-6" y="-6" heading="45" viewing_angle="90" range="14"/>
      <camera name="B" x="6" y="0" heading="0" viewing_angle="360" range="7"/>
      """;

  private static final String TRACKS =
      """
      tracks 1
      interval 0.5
      target 1 size 0.66
      0 -5 -5
      -4.5 -4.5
      -4 -3
      4.25 3 2
      6 -2 5
      target 2 size 0.66
      2 8 8
      7 6
      5 1
      target 1 size 0.66
      10.25 0 0
      13 4 -1
      """;

  private static final String EVENTS =
      """
<event timestep="0" participant="object" event="add" name="1" x="-5" y="-5" heading="0" speed="0"/>
<event timestep="13" participant="object" event="error" name="1" duration="-1"/>
<event timestep="4" participant="object" event="add" name="2" x="8" y="8" heading="0" speed="0"/>
<event timestep="7" participant="object" event="error" name="2" duration="-1"/>
<event timestep="21" participant="object" event="add" name="1" x="0" y="0" heading="0" speed="0"/>
<event timestep="27" participant="object" event="error" name="1" duration="-1"/>
""";

  @TempDir Path folder;

  /** All result files are those of a run in HiFi-CamSim. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "camsim-visibility|''|zoom-out",
        "hifi:orb-lin|'detection=hifi:orb-lin,'|greedy",
        "camsim-visibility|''|random"
      })
  void objectsFollowTheirTracksInEachStep(String detection, String option, String policy)
      throws IOException {
    Path tracked = tracked();
    CamSimRun run =
        CamSimRun.of(
            folder.resolve("run"),
            option + "policy=" + policy + ",zooms=4;9,out=results,tracks=" + tracked,
            forCamSim(),
            STEPS);
    assertEquals("", run.err());
    Scenario own = OwnSimulation.scenario(tracked, List.of(4.0, 9.0));
    Path record = folder.resolve("own");
    OwnSimulation.record(
        record,
        own,
        OwnSimulation.detection(detection),
        OwnSimulation.CATALOGUE.policies().create(policy),
        STEPS);
    for (String file : List.of("steps.csv", "zooms.csv", "targets.csv")) {
      assertEquals(Files.readString(record.resolve(file)), run.text("results/" + file), file);
    }
  }

  @Test
  void camSimSeesTracksWithoutOtherOptions() throws IOException {
    Path tracked = tracked();
    CamSimRun run = CamSimRun.of(folder.resolve("run"), "tracks=" + tracked, forCamSim(), STEPS);
    assertEquals("", run.err());
    List<String> places =
        run.rows("looks.csv").stream()
            .map(row -> row.split(","))
            .filter(row -> row[1].equals("A") && row[2].equals("1.0"))
            .map(row -> row[0] + " " + row[4] + " " + row[5])
            .toList();
    assertEquals(19, places.size());
    assertEquals("1 -4.5 -4.5", places.get(1));
    assertEquals("2 -4.0 -3.0", places.get(2));
    assertEquals("12 -2.0 5.0", places.get(12));
    assertEquals("26 4.0 -1.0", places.get(18));
    assertTrue(run.rows("looks.csv").stream().anyMatch(row -> !row.split(",")[6].equals("0.0")));
  }

  @Test
  void reportsCamSimThatSeesObjectsOffTheirTracks() throws IOException {
    Path classes =
        Variant.of(
            folder.resolve("variant"),
            Map.of(
                "double update_visiblity(TraceableObject object) {",
                "double update_visiblity(TraceableObject object) { if (true) return 0.123456;"));
    CamSimRun run =
        CamSimRun.start(
            folder.resolve("run"),
            "tracks=" + tracked(),
            List.of(classes),
            "epics.camwin.Main",
            List.of("-t", "9", forCamSim().toString()));
    assertTrue(run.err().contains("and its track gives"), run.err());
    assertTrue(run.err().endsWith("CamSim runs on unchanged\n"), run.err());
    assertEquals(0, run.exit());
  }

  @Test
  void rejectsScenarioWithoutTracks() throws IOException {
    Path plain = forCamSim();
    CamSimRun run = CamSimRun.of(folder.resolve("run"), "tracks=" + plain, plain, 3);
    assertTrue(run.err().contains("which has none, expected a scenario with <tracks>"), run.err());
  }

  @Test
  void rejectsScenarioWithHeights() throws IOException {
    Path file = tracked();
    String text = Files.readString(file);
    Files.writeString(file, text.replace(" step='0.5'", " step='0.5' seen='head'"));
    CamSimRun run = CamSimRun.of(folder.resolve("run"), "tracks=" + file, forCamSim(), 3);
    String problem = "which has heights, expected a flat scenario: CamSim has none";
    assertTrue(run.err().contains(problem), run.err());
  }

  private Path tracked() throws IOException {
    Files.writeString(folder.resolve("people.tracks"), TRACKS);
    return scenario("tracked.xml", " step='0.5'", "<tracks file='people.tracks'/>");
  }

  private Path forCamSim() throws IOException {
    return scenario("for-camsim.xml", "", EVENTS);
  }

  private Path scenario(String name, String step, String content) throws IOException {
    return Files.writeString(
        folder.resolve(name),
        "<root><simulation min_x='-10' max_x='10' min_y='-10' max_y='10'"
            + step
            + ">"
            + CAMERAS
            + content
            + "</simulation></root>");
  }
}
