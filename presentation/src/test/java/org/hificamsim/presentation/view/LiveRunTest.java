package org.hificamsim.presentation.view;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.Waypoint;
import org.hificamsim.core.world.World;
import org.hificamsim.presentation.replay.Frame;
import org.hificamsim.presentation.replay.Move;
import org.hificamsim.presentation.replay.PackedHeat;
import org.hificamsim.presentation.replay.ReplayJson;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests a live run, and how commands change it. */
class LiveRunTest {
  private static final LiveChoice CHOICE = new LiveChoice("hifi:orb-lin", null, "epsilon-greedy");
  private final Catalogue catalogue = Catalogue.load();

  @TempDir private Path folder;

  private LiveRun live(String scenario, long seed) {
    return live(Scenarios.read(scenario), CHOICE, seed);
  }

  private LiveRun live(Scenario scenario, LiveChoice choice, long seed) {
    LiveRun.ShownScenario shown = new LiveRun.ShownScenario(scenario, List.of());
    return new LiveRun(catalogue, shown, choice, seed, Optional.empty());
  }

  @ParameterizedTest
  @ValueSource(strings = {"cluster-random", "lattice-scripted"})
  void liveRunMakesSameStepsAsSimulation(String name) {
    Scenario scenario = Scenarios.read(name);
    World world = new World(scenario, catalogue.movements(), 5);
    Detection detection = Detection.of(catalogue.detection("hifi:orb-lin"));
    List<List<Integer>> expected = new ArrayList<>();
    new Simulation(
            world,
            detection,
            catalogue.policies().create("epsilon-greedy"),
            5,
            List.of(
                (network, coverage) -> {
                  List<Integer> covered = new ArrayList<>();
                  for (int target = 0; target < network.targets(); target++) {
                    covered.add(network.coverage(target));
                  }
                  expected.add(covered);
                }))
        .run(200);
    LiveRun live = live(name, 5);
    for (int step = 0; step < 200; step++) {
      Frame frame = frame(live.step(), 0);
      assertEquals(step, frame.step());
      assertEquals(expected.get(step), Arrays.stream(frame.coverage()).boxed().toList());
    }
  }

  @Test
  void heatMapBeginsWithNextStepAndChangesNoStep() {
    LiveRun live = live("cluster-random", 5);
    LiveRun withoutHeat = live("cluster-random", 5);
    steps(live, 10);
    steps(withoutHeat, 10);
    assertEquals(List.of(), live.heats(), "not recorded");
    live.recordHeat(true);
    assertEquals(List.of(), live.heats(), "before the next step");
    for (int step = 0; step < 20; step++) {
      assertEquals(ReplayJson.of(withoutHeat.step()), ReplayJson.of(live.step()));
    }
    assertEquals(1, live.heats().size());
    assertEquals(10, live.heats().get(0).first());
    assertEquals(20, live.heats().get(0).steps());
    live.drag(0, 3, 3);
    assertEquals(List.of(), live.heats(), "began again");
    live.compare(true);
    live.step();
    assertEquals(List.of(1L, 1L), live.heats().stream().map(PackedHeat::steps).toList());
    live.recordHeat(false);
    live.step();
    assertEquals(List.of(), live.heats());
  }

  @Test
  void simulationThatIsAddedLaterHasSameTargets() {
    LiveRun live = live("cluster-random", 3);
    steps(live, 70);
    live.compare(true);
    live.choose(1, new LiveChoice("geometric", null, "zoom-out"));
    boolean differs = false;
    for (int number = 70; number < 200; number++) {
      LiveStep step = live.step();
      assertEquals(number, frame(step, 0).step());
      assertEquals(number, frame(step, 1).step());
      assertArrayEquals(frame(step, 0).x(), frame(step, 1).x());
      assertArrayEquals(frame(step, 0).y(), frame(step, 1).y());
      differs |= !Arrays.equals(frame(step, 0).coverage(), frame(step, 1).coverage());
    }
    assertTrue(differs);
  }

  @Test
  void targetsStayWhenChoiceChanges() {
    LiveRun changed = live("ring-random", 1);
    LiveRun same = live("ring-random", 1);
    for (int step = 0; step < 100; step++) {
      if (step == 40) {
        changed.choose(0, new LiveChoice("camsim-range", 0.3, "sarsa"));
      }
      Frame frame = frame(changed.step(), 0);
      assertArrayEquals(frame(same.step(), 0).x(), frame.x());
      assertEquals(step, frame.step());
    }
    assertEquals("Q", changed.sides().get(0).estimated());
    assertEquals(0.3, changed.sides().get(0).setup().threshold());
  }

  @Test
  void cameraIsMovedInBothSimulations() {
    LiveRun live = live("lattice-random", 0);
    live.compare(true);
    steps(live, 2);
    live.drag(1, 0.25, -0.5);
    LiveStep step = live.step();
    for (LiveStep.Side side : step.sides()) {
      Move move = side.moves().get(0);
      assertEquals(1, side.moves().size());
      assertEquals(1, move.camera());
      assertEquals(0.25, move.pose().x());
      assertEquals(-0.5, move.pose().y());
    }
    live.restart(0, true);
    assertEquals(0.25, live.step().sides().get(0).moves().get(1).pose().x());
    live.restart(0, false);
    assertNotEquals(0.25, live.step().sides().get(0).moves().get(1).pose().x());
  }

  @Test
  void firstStepAfterComparingHasAllPoses() {
    LiveRun live = live("cluster-random", 0);
    steps(live, 2);
    live.drag(2, 0, 0);
    steps(live, 2);
    live.compare(true);
    LiveStep step = live.step();
    List<Move> moves = step.sides().get(0).moves();
    assertEquals(14, moves.size());
    assertEquals(0, moves.get(2).pose().x());
    assertEquals(ReplayJson.of(moves), ReplayJson.of(step.sides().get(1).moves()));
    live.compare(false);
    assertEquals(
        ReplayJson.of(moves.get(2).pose()),
        ReplayJson.of(live.step().sides().get(0).moves().get(2).pose()));
  }

  @Test
  void headingStaysInAddedSimulationAndAfterRestart() {
    LiveRun live = live("lattice-random", 0);
    steps(live, 2);
    live.turn(1, 30);
    assertEquals(Math.toRadians(30), live.step().sides().get(0).moves().get(0).pose().heading());
    live.compare(true);
    LiveStep step = live.step();
    assertEquals(Math.toRadians(30), step.sides().get(1).moves().get(1).pose().heading());
    live.restart(0, true);
    assertEquals(Math.toRadians(30), live.step().sides().get(0).moves().get(1).pose().heading());
    assertThrows(InputException.class, () -> live.turn(1, Double.NaN));
    assertThrows(InputException.class, () -> live.turn(99, 0));
  }

  @ParameterizedTest
  @ValueSource(strings = {"cluster-random", "tutorial-camsim"})
  void addedCameraDoesNotChangeTargets(String name) {
    LiveRun live = live(name, 4);
    LiveRun same = live(name, 4);
    steps(live, 30);
    steps(same, 30);
    int starts = live.scenario().cameras().size();
    live.drag(0, 1, 2);
    live.addCopy(0, 3, -4);
    List<CameraSpec> cameras = live.scenario().cameras();
    assertEquals("added-1", cameras.get(starts).name());
    assertEquals(1, cameras.get(0).x());
    assertEquals(3, cameras.get(starts).x());
    assertEquals(-4, cameras.get(starts).y());
    assertEquals(cameras.get(0).range(), cameras.get(starts).range());
    for (int step = 30; step < 200; step++) {
      Frame frame = frame(live.step(), 0);
      assertArrayEquals(frame(same.step(), 0).x(), frame.x());
      assertEquals(step, frame.step());
      assertTrue(frame.online()[starts]);
    }
    live.addCopy(starts, 0, 0);
    assertEquals("added-2", live.scenario().cameras().get(starts + 1).name());
    live.restart(4, false);
    assertEquals(starts, live.scenario().cameras().size());
  }

  @ParameterizedTest
  @ValueSource(strings = {"cluster-scripted", "tutorial-camsim"})
  void editedScenarioRunsSameAfterWritingAndReading(String name) {
    LiveRun live = live(name, 7);
    live.drag(1, 0.125, -0.5);
    live.turn(1, 77.5);
    live.addCopy(0, 2, 2);
    Path file = folder.resolve("edited.xml");
    assertDoesNotThrow(() -> Files.writeString(file, ScenarioWriter.write(live.scenario())));
    Scenario read = ScenarioReader.read(file, catalogue.movements()::knows, warning -> {});
    LiveRun other = live(read, CHOICE, 7);
    live.restart(7, true);
    for (int step = 0; step < 60; step++) {
      assertEquals(ReplayJson.of(live.step()), ReplayJson.of(other.step()));
    }
  }

  @Test
  void wallHidesTargetsUntilItIsRemoved() {
    LiveRun live = live(Scenarios.read("ring-scripted"), zoomOut(), 0);
    int withoutWalls = detections(live, 60);
    live.restart(0, true);
    Scenario original = live.scenario();
    List<CameraSpec> cameras = original.cameras();
    for (CameraSpec camera : cameras) {
      live.edit(
          scenario ->
              addWall(
                  scenario,
                  camera.x() + 0.01,
                  camera.y() - 0.02,
                  camera.x() + 0.01,
                  camera.y() + 0.02));
    }
    assertEquals(cameras.size(), live.sides().get(0).setup().obstacles().size());
    int withWalls = detections(live, 60);
    assertTrue(withWalls < withoutWalls && withWalls > 0, withWalls + " of " + withoutWalls);
    for (int i = 0; i < cameras.size(); i++) {
      live.edit(scenario -> scenario.removeObstacle(0));
    }
    live.restart(0, true);
    assertEquals(withoutWalls, detections(live, 60));
    assertEquals(original, live.scenario());
  }

  private static int detections(LiveRun live, int steps) {
    int sum = 0;
    for (int i = 0; i < steps; i++) {
      sum += Arrays.stream(frame(live.step(), 0).detected()).sum();
    }
    return sum;
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0, 0, 0, both ends",
    "99, 0, 0, 0, in the field",
    "NaN, 0, 0, 0, in the field",
    "0, Infinity, 0, 0, in the field"
  })
  void rejectsInvalidWalls(double x1, double y1, double x2, double y2, String expected) {
    LiveRun live = live("ring-random", 0);
    Scenario before = live.scenario();
    InputException refused =
        assertThrows(
            InputException.class, () -> live.edit(scenario -> addWall(scenario, x1, y1, x2, y2)));
    assertTrue(refused.getMessage().contains(expected), refused.getMessage());
    assertThrows(InputException.class, () -> live.edit(scenario -> scenario.removeObstacle(0)));
    assertEquals(before, live.scenario());
  }

  @Test
  void rejectsCamerasInWalls() {
    LiveRun live = live("ring-random", 0);
    CameraSpec first = live.scenario().cameras().get(0);
    assertThrows(
        InputException.class,
        () ->
            live.edit(
                scenario ->
                    addWall(scenario, first.x(), first.y() - 0.1, first.x(), first.y() + 0.1)));
    live.edit(scenario -> addWall(scenario, 0.123, -1, 0.123, 1));
    assertThrows(InputException.class, () -> live.drag(0, 0.123, 0.5));
    assertThrows(InputException.class, () -> live.addCopy(0, 0.123, 0.5));
  }

  @Test
  void changesAreUndoneAndRedoneOneByOne() {
    LiveRun live = live("cluster-scripted", 0);
    Scenario before = live.scenario();
    live.drag(2, 1, 1);
    live.drag(2, 2, 1);
    live.turn(2, 30);
    Scenario moved = live.scenario();
    live.edit(scenario -> scenario.removeCamera(0));
    live.edit(scenario -> scenario.removeTarget(1));
    live.edit(scenario -> addWall(scenario, -3, -3, -2, -3));
    assertEquals(before.cameras().size() - 1, live.scenario().cameras().size());
    assertEquals(before.everyTarget().count() - 1, live.step().sides().get(0).frame().x().length);
    Scenario after = live.scenario();
    live.undo();
    live.undo();
    live.undo();
    assertEquals(moved, live.scenario());
    assertEquals(2, nextX(live, 2));
    live.undo();
    assertEquals(before, live.scenario(), "dragging and turning one camera is one change");
    assertEquals(before.cameras().get(2).x(), nextX(live, 2));
    assertThrows(InputException.class, live::undo);
    for (int i = 0; i < 4; i++) {
      live.redo();
    }
    assertEquals(after, live.scenario());
    assertThrows(InputException.class, live::redo);
    live.undo();
    live.edit(scenario -> scenario.removeTarget(0));
    assertThrows(InputException.class, live::redo, "another change was made since");
    assertThrows(InputException.class, () -> live.edit(scenario -> scenario.removeCamera(99)));
    assertThrows(InputException.class, () -> live.edit(scenario -> scenario.removeTarget(-1)));
  }

  /** Makes a step, and returns the x coordinate of a camera. */
  private static double nextX(LiveRun live, int camera) {
    return live.step().sides().get(0).moves().get(camera).pose().x();
  }

  @Test
  void changeWhilePausedRepeatsStep() {
    LiveRun live = live("cluster-scripted", 0);
    steps(live, 10);
    live.setPaused(true);
    live.edit(scenario -> addWall(scenario, -3, -3, -2, -3));
    assertEquals(9, live.step().number());
    live.undo();
    assertEquals(9, live.step().number());
    live.setPaused(false);
    live.redo();
    assertEquals(10, live.step().number());
  }

  @Test
  void warnsOfBlockedTargetUntilWallIsRemoved() {
    LiveRun live = live("cluster-scripted", 0);
    assertEquals("", live.warning());
    TargetSpec target = live.scenario().everyTarget().findFirst().orElseThrow();
    Waypoint from = target.waypoints().get(0);
    Waypoint to = target.waypoints().get(1);
    double x = (from.x() + to.x()) / 2;
    double y = (from.y() + to.y()) / 2;
    live.edit(
        scenario ->
            addWall(
                scenario,
                x - 0.1 * (to.y() - from.y()),
                y + 0.1 * (to.x() - from.x()),
                x + 0.1 * (to.y() - from.y()),
                y - 0.1 * (to.x() - from.x())));
    assertTrue(live.warning().contains(" leads through a solid obstacle"), live.warning());
    live.undo();
    assertEquals("", live.warning());
  }

  @Test
  void cameraStaysInViewInWhichItIsHeld() {
    LiveRun live = live(Scenarios.hall(), new LiveChoice("hifi:orb-lin", null, "random"), 0);
    live.compare(true);
    live.hold(1, 7);
    for (int i = 0; i < 30; i++) {
      LiveStep step = live.step();
      assertEquals(7, frame(step, 0).level()[1]);
      assertEquals(7, frame(step, 1).level()[1]);
    }
    assertEquals(List.of(1), live.held());
    live.addCopy(0, 20, 10);
    assertEquals(7, frame(live.step(), 0).level()[1], "another camera changes nothing");
    live.hold(1, -1);
    assertTrue(IntStream.range(0, 30).anyMatch(step -> frame(live.step(), 0).level()[1] != 7));
    assertThrows(InputException.class, () -> live.hold(1, 25));
    assertThrows(InputException.class, () -> live.hold(1, -2));
    assertThrows(InputException.class, () -> live.hold(9, 0));
  }

  @Test
  void wallsAndOpticsOfEditedScenarioAreWritten() throws Exception {
    LiveRun live = live(Scenarios.hall(), zoomOut(), 7);
    live.edit(scenario -> addWall(scenario, 25, 15, 28.5, 15));
    live.edit(scenario -> scenario.removeObstacle(1));
    live.turn(0, 45);
    Path file = folder.resolve("edited.xml");
    Files.writeString(file, ScenarioWriter.write(live.scenario()));
    Scenario read = ScenarioReader.read(file, catalogue.movements()::knows, warning -> {});
    assertEquals(live.scenario().with(Scenario.NAME, read.name()), read);
    LiveRun other = live(read, zoomOut(), 7);
    live.restart(7, true);
    for (int step = 0; step < 30; step++) {
      assertEquals(ReplayJson.of(live.step()), ReplayJson.of(other.step()));
    }
  }

  @Test
  void draggedCameraDetectsTargetsAtItsNewPlace() {
    LiveRun live = live(Scenarios.read("ring-random"), zoomOut(), 0);
    LiveRun unchanged = live(Scenarios.read("ring-random"), zoomOut(), 0);
    steps(live, 10);
    steps(unchanged, 10);
    Frame before = frame(unchanged.step(), 0);
    live.drag(0, before.x()[0], before.y()[0]);
    Frame after = frame(live.step(), 0);
    assertArrayEquals(before.x(), after.x());
    assertEquals(live.sides().get(0).world().cameras().x(0), before.x()[0]);
    assertNotEquals(0, after.detected()[0]);
  }

  private static LiveChoice zoomOut() {
    return new LiveChoice("geometric", null, "zoom-out");
  }

  @Test
  void thresholdInNameOfDetectionOverridesOthers() {
    LiveRun live = live("cluster-random", 0);
    live.choose(0, new LiveChoice("geometric@0.25", 0.5, "zoom-out"));
    assertEquals(0.25, live.sides().get(0).setup().threshold());
    assertEquals("geometric@0.25", live.sides().get(0).setup().detection());
  }

  @Test
  void sameCommandsGiveSameFrames() {
    Consumer<LiveRun> commands =
        live -> {
          live.drag(2, 1, 1);
          live.choose(0, new LiveChoice("hifi:sift-lin", 0.05, "softmax"));
          live.compare(true);
        };
    List<String> frames = framesAfter(commands);
    assertEquals(frames, framesAfter(commands));
    assertEquals(60, frames.size());
  }

  private List<String> framesAfter(Consumer<LiveRun> commands) {
    LiveRun live = live("cluster-random", 9);
    List<String> frames = new ArrayList<>();
    for (int step = 0; step < 60; step++) {
      if (step == 20) {
        commands.accept(live);
      }
      frames.add(ReplayJson.of(live.step()));
    }
    return frames;
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "nothing | | zoom-out | unknown detection 'nothing'",
        "geometric | | nothing | unknown policy 'nothing'",
        "geometric | | sarsa:alpha=x | alpha is 'x'",
        "geometric | | fixed:99 | level of camera",
        "geometric | 2 | zoom-out | threshold is 2.0, expected a number from 0 to 1",
        "geometric | NaN | zoom-out | threshold is NaN",
        "geometric | | best-fixed | cannot be viewed live",
        "scenarios/model.json | | zoom-out | unknown detection 'scenarios/model.json'",
      })
  void rejectsInvalidChoices(String detection, Double threshold, String policy, String expected) {
    LiveRun live = live("cluster-random", 0);
    InputException wrong =
        assertThrows(
            InputException.class,
            () -> live.choose(0, new LiveChoice(detection, threshold, policy)));
    assertTrue(wrong.getMessage().contains(expected), wrong.getMessage());
    assertEquals("epsilon-greedy", live.sides().get(0).setup().policy());
  }

  @ParameterizedTest
  @CsvSource({"-1,0,0", "99,0,0", "0,1e9,0", "0,NaN,0", "0,0,Infinity"})
  void rejectsInvalidPlaces(int camera, double x, double y) {
    LiveRun live = live("cluster-random", 0);
    assertThrows(InputException.class, () -> live.drag(camera, x, y));
  }

  @Test
  void fullFeedKeepsLastStepAndAllMoves() {
    LiveRun live = live("lattice-random", 0);
    LiveFeed feed = new LiveFeed(10);
    for (int step = 0; step < 100; step++) {
      if (step % 7 == 0) {
        live.drag(0, step / 100.0, 0);
      }
      feed.add(live.step());
      List<LiveStep> kept = feed.steps();
      assertTrue(kept.size() <= 10);
      assertEquals(step, frame(kept.get(kept.size() - 1), 0).step());
    }
    List<Double> positions =
        feed.steps().stream()
            .flatMap(step -> step.sides().get(0).moves().stream())
            .filter(move -> move.camera() == 0)
            .map(move -> move.pose().x())
            .toList();
    assertEquals(0.98, positions.get(positions.size() - 1));
    assertTrue(
        feed.steps().stream()
            .map(step -> step.sides().get(0).moves())
            .allMatch(moves -> moves.stream().map(Move::camera).distinct().count() == moves.size()),
        "one move of a camera per step");
  }

  private static Frame frame(LiveStep step, int side) {
    return step.sides().get(side).frame();
  }

  private static void addWall(EditedScenario scenario, double x1, double y1, double x2, double y2) {
    scenario.addObstacle(DrawnObstacle.WALL, new Point(x1, y1), new Point(x2, y2), null);
  }

  private static void steps(LiveRun live, int count) {
    for (int i = 0; i < count; i++) {
      live.step();
    }
  }
}
