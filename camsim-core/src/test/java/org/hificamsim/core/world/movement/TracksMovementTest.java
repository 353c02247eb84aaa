package org.hificamsim.core.world.movement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.hificamsim.core.AllocatedBytes;
import org.hificamsim.core.InputException;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.engine.WidestPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class TracksMovementTest {
  private static final Detection DETECTION = Detection.of(new GeometricDetection());
  private static final String WALK =
      "tracks 1\ninterval 2\ntarget 1 size 1\n2 0 0\n4 8\n4 0\ntarget 1 size 1\n9 -1 -1\n";

  @TempDir Path folder;

  @ParameterizedTest
  @EnumSource(StepOrder.class)
  void followsTrackInEitherStepOrder(StepOrder order) throws IOException {
    List<String> seen = seen(scenario(1, WALK).with(Scenario.ORDER, order), 11);
    assertEquals(
        List.of(
            "-",
            "-",
            "0.0,0.0",
            "2.0,4.0",
            "4.0,8.0",
            "4.0,4.0",
            "4.0,0.0",
            "-",
            "-",
            "-1.0,-1.0",
            "-"),
        seen);
  }

  @Test
  void stepTimeDoesNotChangeTrack() throws IOException {
    List<String> seen = seen(scenario(1.5, WALK).with(Scenario.ORDER, StepOrder.COVERAGE), 7);
    assertEquals(List.of("-", "-", "2.0,4.0", "4.0,6.0", "4.0,0.0", "-", "-1.0,-1.0"), seen);
  }

  @Test
  void absentTargetsDoNotCount() throws IOException {
    List<Integer> counted = new ArrayList<>();
    Scenario scenario = scenario(1, WALK + "target 2 size 1\n0 1 1\n" + "1 1\n".repeat(4));
    run(world(scenario), 11, (network, coverage) -> counted.add(coverage.targets()));
    assertEquals(List.of(1, 1, 2, 2, 2, 2, 2, 1, 1, 1, 0), counted);
  }

  @Test
  void hasFirstHeadingAndMeanSpeed() throws IOException {
    World world = world(scenario(1, WALK));
    for (int step = 0; step < 4; step++) {
      world.fireEvents(step);
      world.moveTargets();
    }
    Targets targets = world.targets();
    assertEquals(Math.atan2(4, 8), targets.heading(0), 1e-12);
    assertEquals((Math.hypot(4, 8) + 8) / 4, targets.speed(0), 1e-12);
  }

  @Test
  void stepsThatAddAndRemoveTargetsAllocateNothing() throws IOException {
    StringBuilder text = new StringBuilder("tracks 1\ninterval 1\n");
    for (int i = 0; i < 400; i++) {
      text.append("target " + i + " size 1\n" + i + " 0 0\n0 1\n0 2\n");
    }
    Simulation simulation =
        new Simulation(
            world(scenario(1, text.toString())), DETECTION, new WidestPolicy(), 0, List.of());
    simulation.run(100);
    assertEquals(0, AllocatedBytes.fewest(() -> AllocatedBytes.by(() -> simulation.run(20))));
  }

  @Test
  void rejectsTargetWithoutTrack() {
    TargetSpec lost = TestScenario.target(3, 0, 0, 0, 0).withMovement("Tracks");
    TestScenario scenario = new TestScenario().camera(0, 0).target(lost);
    InputException error = assertThrows(InputException.class, scenario::world);
    assertEquals(
        "target 3.0 moves by Tracks and has no track, expected one of <tracks>",
        error.getMessage());
  }

  /** Positions are precomputed or, if there are too many, computed on the way. */
  @ParameterizedTest
  @ValueSource(strings = {"", "target 999 size 1\n0 0 0\n9000000 1 1\n"})
  void interpolatesSamplesExactly(String tooLongForMemory) throws IOException {
    for (StepOrder order : StepOrder.values()) {
      List<double[]> tracks = new ArrayList<>();
      String text = randomTracks(new SplittableRandom(5), tracks) + tooLongForMemory;
      Scenario scenario = scenario(0.7, text).with(Scenario.ORDER, order);
      World world = world(scenario);
      int[] compared = new int[1];
      run(
          world,
          120,
          (network, coverage) -> compared[0] += compare(world.targets(), network.step(), tracks));
      assertTrue(compared[0] > 2000, "places compared: " + compared[0]);
    }
  }

  /** Writes tracks of targets 0 to 49, and adds their samples (time, x, y) to the list. */
  private static String randomTracks(SplittableRandom random, List<double[]> tracks) {
    StringBuilder text = new StringBuilder("tracks 1\ninterval 1\n");
    for (int target = 0; target < 50; target++) {
      double[] samples = new double[3 * random.nextInt(1, 60)];
      double time = random.nextDouble(20);
      text.append("target " + target + " size 1\n");
      for (int i = 0; i < samples.length; i += 3) {
        samples[i] = time;
        samples[i + 1] = random.nextDouble(-10, 10);
        samples[i + 2] = random.nextDouble(-10, 10);
        text.append(samples[i] + " " + samples[i + 1] + " " + samples[i + 2] + "\n");
        time += random.nextDouble(0.1, 3);
      }
      tracks.add(samples);
    }
    return text.toString();
  }

  private static int compare(Targets targets, long step, List<double[]> tracks) {
    int compared = 0;
    for (int i = 0; i < targets.count(); i++) {
      int target = (int) Double.parseDouble(targets.name(i));
      if (targets.present(i) && target < tracks.size()) {
        assertEquals(position(tracks.get(target), step * 0.7, 1), targets.x(i));
        assertEquals(position(tracks.get(target), step * 0.7, 2), targets.y(i));
        compared++;
      }
    }
    return compared;
  }

  private static double position(double[] samples, double time, int axis) {
    int leg = 0;
    while (leg + 3 < samples.length && samples[leg + 3] <= time) {
      leg += 3;
    }
    if (leg + 3 == samples.length) {
      return samples[leg + axis];
    }
    double part = Math.max(0, (time - samples[leg]) / (samples[leg + 3] - samples[leg]));
    return samples[leg + axis] + part * (samples[leg + 3 + axis] - samples[leg + axis]);
  }

  @Test
  void walksThroughWallsAsRecorded() throws IOException {
    String wall = "<wall x1='-9' y1='3' x2='9' y2='3'/>";
    assertEquals("4.0,8.0", seen(scenario(1, WALK, wall), 5).get(4));
  }

  private Scenario scenario(double step, String tracks) throws IOException {
    return scenario(step, tracks, "");
  }

  private Scenario scenario(double step, String tracks, String obstacles) throws IOException {
    Path file = folder.resolve("walk.xml");
    Files.writeString(folder.resolve("walk.tracks"), tracks);
    Files.writeString(
        file,
        "<root><simulation min_x='-10' max_x='10' min_y='-10' max_y='10' step='"
            + step
            + "'>"
            + obstacles
            + "<camera name='a' x='0' y='-9' heading='0' viewing_angle='90' range='5'/><tracks"
            + " file='walk.tracks'/></simulation></root>");
    return ScenarioReader.read(file, Movements.registry().names()::contains, warning -> {});
  }

  private static World world(Scenario scenario) {
    return new World(scenario, Movements.registry(), 0);
  }

  private static List<String> seen(Scenario scenario, int steps) {
    World world = world(scenario);
    List<String> seen = new ArrayList<>();
    run(world, steps, (network, coverage) -> seen.add(present(world.targets())));
    return seen;
  }

  private static String present(Targets targets) {
    return IntStream.range(0, targets.count())
        .filter(targets::present)
        .mapToObj(target -> targets.x(target) + "," + targets.y(target))
        .findFirst()
        .orElse("-");
  }

  private static void run(World world, int steps, StepListener listener) {
    new Simulation(world, DETECTION, new WidestPolicy(), 0, List.of(listener)).run(steps);
  }
}
