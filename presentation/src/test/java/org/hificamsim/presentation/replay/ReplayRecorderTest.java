package org.hificamsim.presentation.replay;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.output.ResultFolder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ReplayRecorderTest {
  private static final Path SCENARIOS =
      Path.of(System.getProperty("hificamsim.root", "."), "scenarios");

  private final Catalogue catalogue = Catalogue.load();

  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(
      strings = {
        "epsilon-greedy",
        "softmax",
        "ucb1",
        "sarsa",
        "qb-sarsa",
        "cooperative",
        "zoom-out"
      })
  void recordedStepsAreExactToMillimetre(String policy) throws IOException {
    RunPlan plan = plan("cluster-random", policy, 300, 1);
    List<Frame> seen = record(plan, ReplayRecorder.Limits.DEFAULT);
    RecordedRun recording = Replay.read(folder).recording(folder, 0);
    assertEquals(300, recording.frames().size());
    assertEquals(policy.equals("zoom-out"), recording.estimated().isEmpty());
    assertEquals(policy.equals("cooperative"), recording.frames().get(0).belief().length > 0);
    for (int step = 0; step < 300; step++) {
      assertClose(seen.get(step), recording.frames().get(step));
    }
  }

  @Test
  void longRunIsThinnedButKeepsLastStep() throws IOException {
    RunPlan plan = plan("lattice-random", "sarsa", 1000, 1);
    List<Frame> seen = record(plan, new ReplayRecorder.Limits(100, 1 << 20, 1 << 20));
    RecordedRun recording = Replay.read(folder).recording(folder, 0);
    assertEquals(1000, recording.steps());
    assertEquals(16, recording.every());
    assertEquals(64, recording.frames().size());
    assertEquals(999, recording.frames().get(63).step());
    for (Frame frame : recording.frames()) {
      assertTrue(frame.step() % 16 == 0 || frame.step() == 999);
      assertClose(seen.get((int) frame.step()), frame);
    }
  }

  @Test
  void runIsThinnedUntilItsBytesFit() throws IOException {
    record(
        plan("lattice-random", "sarsa", 1000, 1),
        new ReplayRecorder.Limits(10_000, 1 << 20, 20_000));
    Replay replay = Replay.read(folder);
    assertTrue(replay.runs().get(0).every() > 1);
    long bytes = Files.size(folder.resolve(ResultFolder.REPLAY));
    assertTrue(bytes <= 20_500, bytes + " bytes");
  }

  @Test
  void firstAndLastFrameStayIfSetupIsTooLarge() throws IOException {
    record(plan("lattice-random", "sarsa", 100, 2), new ReplayRecorder.Limits(10_000, 1 << 20, 10));
    Replay replay = Replay.read(folder);
    assertEquals(1, replay.runs().size());
    List<Frame> frames = replay.recording(folder, 0).frames();
    assertEquals(0, frames.get(0).step());
    assertEquals(99, frames.get(frames.size() - 1).step());
    assertTrue(frames.size() <= 3, frames.size() + " frames");
  }

  @Test
  void asManyRepeatsAreRecordedAsFit() throws IOException {
    RunPlan plan = plan("lattice-random", "sarsa", 200, 5);
    record(plan, ReplayRecorder.Limits.DEFAULT);
    Replay unlimited = Replay.read(folder);
    assertEquals(5, unlimited.runs().size());
    assertEquals(4, unlimited.runs().get(4).seed());
    int setup = ReplayJson.of(unlimited.setup()).length();
    record(
        plan,
        new ReplayRecorder.Limits(
            1000, 1 << 20, setup + 2 * unlimited.runs().get(0).data().length() + 2000));
    assertEquals(2, Replay.read(folder).runs().size());
    assertEquals(5, Replay.read(folder).repeat());
  }

  @Test
  void camerasThatEventsChangeAreRecorded() throws IOException {
    Path scenario = folder.resolve("moving.xml");
    Files.writeString(
        scenario,
        Files.readString(SCENARIOS.resolve("lattice-random.xml"))
            .replaceFirst(
                "</simulation>",
                """
<events>
<event timestep="3" participant="camera" event="change" name="Cam_01" x="1.5" y="-1" heading="90" viewing_angle="-1" range="-1"/>
<event timestep="5" participant="camera" event="error" name="Cam_02" duration="-1"/>
</events></simulation>"""));
    record(plan(scenario, "epsilon-greedy", 10, 1), ReplayRecorder.Limits.DEFAULT);
    RecordedRun recording = Replay.read(folder).recording(folder, 0);
    assertEquals(1, recording.moves().size(), recording.moves().toString());
    Move move = recording.moves().get(0);
    assertEquals(3, move.step());
    assertEquals(1.5, move.pose().x());
    assertEquals(Math.PI / 2, move.pose().heading(), 1e-12);
    assertTrue(recording.frames().get(4).online()[1]);
    assertTrue(!recording.frames().get(5).online()[1]);
  }

  @Test
  void turningCamerasAndObstaclesAreRecorded() throws IOException {
    Path hall = SCENARIOS.resolveSibling("src/test/resources/seen/hall.xml");
    RunPlan plan = plan(hall, "epsilon-greedy:epsilon=0.5", 100, 1);
    List<Frame> seen = record(plan, ReplayRecorder.Limits.DEFAULT);
    Replay replay = Replay.read(folder);
    List<Frame> frames = replay.recording(folder, 0).frames();
    int blind = 0;
    for (int step = 0; step < 100; step++) {
      assertClose(seen.get(step), frames.get(step));
      assertArrayEquals(seen.get(step).seeing(), frames.get(step).seeing());
      blind += frames.get(step).seeing()[0] < 0 ? 1 : 0;
      assertEquals(frames.get(step).level()[2], frames.get(step).seeing()[2], "turns at once");
    }
    assertTrue(blind > 0 && blind < 100, blind + " steps");
    assertEquals(List.of(0, 1), replay.setup().slow());
    assertEquals(plan.scenario().obstacles(), replay.setup().obstacles());
    assertEquals(List.of(0.5, 0.5, 1.8, 0.5, 0.5), replay.setup().widths());
    CameraPose pose = replay.setup().cameras().get(0).pose();
    assertEquals(25, pose.views());
    assertEquals(25, frames.get(0).estimates()[0].length);
    assertEquals(Math.toRadians(90 - 60), pose.heading() + pose.pans().get(0), 1e-12);
    assertEquals(Math.toRadians(8), pose.lenses().get(0).viewingAngle(), 1e-12);
    assertEquals(640 / (2 * Math.tan(Math.toRadians(4))), pose.lenses().get(0).density(), 1e-6);
  }

  @Test
  void recordingOmitsWhatScenarioDoesNotHave() throws IOException {
    record(plan("lattice-random", "zoom-out", 3, 1), ReplayRecorder.Limits.DEFAULT);
    String json = Files.readString(folder.resolve(ResultFolder.REPLAY));
    for (String name :
        List.of("pans", "lenses", "visible", "widths", "slow", "obstacles", "floor", "seeing")) {
      assertTrue(!json.contains('"' + name + '"'), name);
    }
  }

  @Test
  void distancesOfDetectionAreRecorded() throws IOException {
    record(plan("lattice-random", "zoom-out", 1, 1), ReplayRecorder.Limits.DEFAULT);
    Setup setup = Replay.read(folder).setup();
    assertEquals("lattice-random", setup.scenario());
    assertEquals(0.66, setup.targetSize());
    for (CameraPose.Level level : setup.cameras().get(0).pose().levels()) {
      for (CameraPose.Interval interval : level.detected()) {
        assertTrue(interval.from() <= interval.to() && interval.to() <= level.radius());
      }
    }
    assertTrue(setup.cameras().get(0).pose().levels().get(0).detected().size() > 0);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "{}",
        "[]",
        "nothing",
        "{\"format\":\"hificamsim-replay-0\",\"repeat\":1,\"setup\":null,\"runs\":[]}",
        ""
      })
  void rejectsOtherFileByName(String text) throws IOException {
    Files.writeString(folder.resolve(ResultFolder.REPLAY), text);
    InputException refused = assertThrows(InputException.class, () -> Replay.read(folder));
    assertTrue(refused.getMessage().contains("replay.json"), refused.getMessage());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "\"widths\":[|\"widths\":[1,",
        "\"lenses\":[|\"lenses\":[{\"viewingAngle\":1,\"density\":0},",
        "\"visible\":[|\"visible\":[1,",
        "\"kind\":\"wall\"|\"kind\":\"door\"",
        "\"radius\":0.8|\"radius\":-1",
      })
  void rejectsInconsistentPoseInOneLine(String change) throws IOException {
    Path hall = SCENARIOS.resolveSibling("src/test/resources/seen/hall.xml");
    record(plan(hall, "zoom-out", 3, 1), ReplayRecorder.Limits.DEFAULT);
    Path file = folder.resolve(ResultFolder.REPLAY);
    String[] words = change.split("\\|");
    String json = Files.readString(file);
    assertTrue(json.contains(words[0]), words[0]);
    Files.writeString(file, json.replace(words[0], words[1]));
    InputException refused = assertThrows(InputException.class, () -> Replay.read(folder));
    assertTrue(refused.getMessage().contains("replay.json"), refused.getMessage());
    assertEquals(1, refused.getMessage().lines().count(), refused.getMessage());
  }

  @Test
  void rejectsTruncatedData() throws IOException {
    record(plan("lattice-random", "sarsa", 50, 1), ReplayRecorder.Limits.DEFAULT);
    Path file = folder.resolve(ResultFolder.REPLAY);
    Files.writeString(file, Files.readString(file).replaceFirst("\"frames\":50", "\"frames\":49"));
    Files.writeString(file, Files.readString(file).replaceFirst("(\"data\":\".{400})[^\"]*", "$1"));
    InputException refused =
        assertThrows(InputException.class, () -> Replay.read(folder).recording(folder, 0));
    assertTrue(refused.getMessage().contains("run 0"), refused.getMessage());
  }

  private RunPlan plan(String scenario, String policy, int steps, int repeats) {
    return plan(SCENARIOS.resolve(scenario + ".xml"), policy, steps, repeats);
  }

  private RunPlan plan(Path scenario, String policy, int steps, int repeats) {
    return new RunPlan(
        ScenarioReader.read(scenario, catalogue.movements().names()::contains, warning -> {}),
        Detection.of(catalogue.detection("hifi:orb-lin")),
        policy,
        steps,
        0,
        repeats);
  }

  /** Records a plan into the folder, and returns the first run's original frames. */
  private List<Frame> record(RunPlan plan, ReplayRecorder.Limits limits) throws IOException {
    World world = new World(plan.scenario(), catalogue.movements(), 0);
    Setup setup = Setup.of(world, plan.detection(), plan.policy(), 0, List.of());
    ReplayRecorder recorder = new ReplayRecorder(setup, plan.detection(), plan.repeats(), limits);
    Watch watch = new Watch(setup, plan.detection());
    new RunExecutor(catalogue)
        .execute(
            plan,
            run ->
                run == 0 ? List.of(recorder.listener(0), watch) : List.of(recorder.listener(run)));
    try (OutputStream out = Files.newOutputStream(folder.resolve(ResultFolder.REPLAY))) {
      recorder.write(out);
    }
    return watch.frames;
  }

  private static void assertClose(Frame expected, Frame actual) {
    assertEquals(expected.step(), actual.step());
    assertArrayEquals(expected.online(), actual.online());
    assertArrayEquals(expected.level(), actual.level());
    assertArrayEquals(expected.detected(), actual.detected());
    assertArrayEquals(expected.present(), actual.present());
    assertArrayEquals(expected.coverage(), actual.coverage());
    assertArrayEquals(expected.x(), actual.x(), 0.000_501);
    assertArrayEquals(expected.y(), actual.y(), 0.000_501);
    assertArrayEquals(expected.belief(), actual.belief(), 1e-9);
    assertEquals(expected.estimates().length, actual.estimates().length);
    for (int camera = 0; camera < expected.estimates().length; camera++) {
      assertArrayEquals(expected.estimates()[camera], actual.estimates()[camera], 1e-4);
      assertArrayEquals(expected.counts()[camera], actual.counts()[camera]);
    }
  }

  /** Keeps all frames, and checks that each has the coverage that the engine measured. */
  private static final class Watch implements StepListener {
    private final Setup setup;
    private final Detection detection;
    private final List<Frame> frames = new ArrayList<>();
    private Snapshots snapshots;

    Watch(Setup setup, Detection detection) {
      this.setup = setup;
      this.detection = detection;
    }

    @Override
    public void started(OracleView network, ZoomPolicy policy) {
      snapshots = new Snapshots(setup, detection, policy);
    }

    @Override
    public void stepped(OracleView network, StepCoverage coverage) {
      Frame frame = snapshots.take(network);
      frames.add(frame);
      assertEquals(coverage.kMin(), frame.measure().kMin());
      assertEquals(coverage.meanK(), frame.measure().meanK());
      assertEquals(coverage.covered1(), frame.measure().covered1());
    }
  }
}
