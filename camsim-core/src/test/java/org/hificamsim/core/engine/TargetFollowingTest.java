package org.hificamsim.core.engine;

import static org.hificamsim.core.TestScenario.camera;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TargetFollowingTest {
  /** A target goes east from x = -9.5, a metre in each step. */
  private static TestScenario eastwardWalk() {
    return new TestScenario().order(StepOrder.COVERAGE).target(-9.5, 0, 90, 1);
  }

  private static FollowingSums follow(TestScenario scenario, int steps) {
    return follow(scenario, new WidestPolicy(), steps, new TargetFollowing());
  }

  private static FollowingSums follow(
      TestScenario scenario, ZoomPolicy policy, int steps, TargetFollowing following) {
    Detection detection = Detection.of(new GeometricDetection());
    new Simulation(scenario.world(), detection, policy, 0, List.of(following)).run(steps);
    return following.sums();
  }

  @Test
  void targetIsLostBetweenTwoCamerasAndFoundAgain() {
    TestScenario scenario =
        eastwardWalk()
            .camera(camera("west", -4, 0, 0, 360, 3))
            .camera(camera("east", 4, 0, 0, 360, 3));
    // Covered in steps 3 to 8 (x from -6.5 to -1.5) and 11 to 16; there from step 0 to 19.
    assertEquals(new FollowingSums(3, 2, 2, 1, 6.0 / 20, 0), follow(scenario, 20));
  }

  @Test
  void targetPassesToTheNextCameraWithoutGap() {
    TestScenario scenario =
        eastwardWalk()
            .camera(camera("west", -6, 0, 0, 360, 4))
            .camera(camera("east", -1, 0, 0, 360, 4));
    // In sight of the first camera until x = -2.5, of the second one from -4.5 to 2.5.
    assertEquals(new FollowingSums(0, Double.NaN, 0, 0, 1, 1), follow(scenario, 13));
  }

  @Test
  void targetThatVanishesWhileLostIsNotFoundAgain() {
    TestScenario scenario =
        eastwardWalk()
            .camera(camera("west", -6, 0, 0, 360, 2))
            .events(new ScenarioEvent.RemoveTarget(10, 0));
    // Covered in steps 2 to 5 of 10.
    assertEquals(new FollowingSums(2, Double.NaN, 1, 0, 4.0 / 10, 0), follow(scenario, 20));
  }

  @Test
  void measuresNothingWithoutTargets() {
    TestScenario scenario = new TestScenario().camera(0, 0);
    FollowingSums none = new FollowingSums(Double.NaN, Double.NaN, 0, 0, Double.NaN, 0);
    assertEquals(none, follow(scenario, 5));
  }

  @Test
  void targetThatNobodyFindsHasNoTimeToFind() {
    TestScenario scenario = eastwardWalk().camera(camera("far", 0, 9, 0, 360, 1));
    assertEquals(new FollowingSums(Double.NaN, Double.NaN, 0, 0, 0, 0), follow(scenario, 9));
  }

  /**
   * Records a letter for the holder of each target in each step: '.' for none, ' ' while it is
   * absent.
   */
  private static final class Diary implements StepListener {
    private final List<StringBuilder> lines = new ArrayList<>();

    @Override
    public void stepped(OracleView network, StepCoverage coverage) {
      for (int target = 0; target < network.targets(); target++) {
        if (lines.size() == target) {
          lines.add(new StringBuilder());
        }
        StringBuilder line = lines.get(target);
        line.append(network.present(target) ? holder(network, target, line) : ' ');
      }
    }

    private static char holder(OracleView network, int target, StringBuilder line) {
      char best = '.';
      double least = Double.POSITIVE_INFINITY;
      for (int camera = 0; camera < network.cameras(); camera++) {
        char letter = (char) ('a' + camera);
        if (network.sees(camera, target)) {
          if (line.length() > 0 && line.charAt(line.length() - 1) == letter) {
            return letter;
          }
          double distance =
              Math.hypot(
                  network.targetX(target) - network.cameraX(camera),
                  network.targetY(target) - network.cameraY(camera));
          if (distance < least) {
            least = distance;
            best = letter;
          }
        }
      }
      return best;
    }
  }

  /** Computes the sums from the letters of the diary. */
  private static FollowingSums recount(Diary diary) {
    List<Integer> finds = new ArrayList<>();
    List<Integer> gaps = new ArrayList<>();
    List<Double> shares = new ArrayList<>();
    double losses = 0;
    double handovers = 0;
    for (StringBuilder line : diary.lines) {
      String life = line.toString();
      for (String stay : life.trim().split(" +")) {
        int first = stay.length() - stay.replaceFirst("^\\.+", "").length();
        if (first < stay.length()) {
          finds.add(first);
        }
        losses += count(stay, "[a-z]\\.");
        for (String gap :
            stay.replaceFirst("^\\.+", "").replaceFirst("\\.+$", "").split("[a-z]+")) {
          if (!gap.isEmpty()) {
            gaps.add(gap.length());
          }
        }
        for (int i = 1; i < stay.length(); i++) {
          boolean held = stay.charAt(i - 1) != '.' && stay.charAt(i) != '.';
          handovers += held && stay.charAt(i - 1) != stay.charAt(i) ? 1 : 0;
        }
      }
      int longest = Arrays.stream(life.split("[. ]+")).mapToInt(String::length).max().orElse(0);
      shares.add((double) longest / life.replace(" ", "").length());
    }
    return new FollowingSums(
        finds.stream().mapToInt(steps -> steps).average().orElse(Double.NaN),
        gaps.stream().mapToInt(steps -> steps).average().orElse(Double.NaN),
        losses,
        gaps.size(),
        shares.stream().mapToDouble(share -> share).average().orElse(Double.NaN),
        handovers);
  }

  private static double count(String text, String pattern) {
    return text.split(pattern, -1).length - 1;
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void sumsEqualRecountOfRecordedSteps(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    TestScenario scenario = new TestScenario().order(StepOrder.COVERAGE).zooms(2, 4, 6);
    for (int i = 0; i < 6; i++) {
      scenario.camera(random.nextDouble(-9, 9), random.nextDouble(-9, 9));
      scenario.target(
          random.nextDouble(-9, 9), random.nextDouble(-9, 9), random.nextDouble(0, 360), 0.7);
    }
    scenario.events(
        new ScenarioEvent.RemoveTarget(60, 2), new ScenarioEvent.FailCamera(40, "c1", 30));
    Diary diary = new Diary();
    TargetFollowing following = new TargetFollowing();
    Detection detection = Detection.of(new GeometricDetection());
    ZoomPolicy policy = new RandomLevels();
    new Simulation(scenario.world(), detection, policy, seed, List.of(following, diary)).run(120);
    FollowingSums expected = recount(diary);
    FollowingSums sums = following.sums();
    assertEquals(expected.losses(), sums.losses());
    assertEquals(expected.endedLosses(), sums.endedLosses());
    assertEquals(expected.handovers(), sums.handovers());
    assertEquals(expected.stepsToFind(), sums.stepsToFind(), 1e-9);
    assertEquals(expected.stepsToFindAgain(), sums.stepsToFindAgain(), 1e-9);
    assertEquals(expected.unbroken(), sums.unbroken(), 1e-9);
    assertTrue(sums.losses() > 10 && sums.handovers() > 3, sums.toString());
  }

  /** Chooses a level for each camera that changes every few steps. */
  private static final class RandomLevels implements ZoomPolicy {
    private SplittableRandom random;

    @Override
    public String name() {
      return "random-levels";
    }

    @Override
    public void begin(NetworkView network, SplittableRandom newRandom) {
      random = newRandom;
    }

    @Override
    public void decide(NetworkView network, int[] views) {
      for (int camera = 0; camera < views.length; camera++) {
        views[camera] = random.nextInt(4) == 0 ? random.nextInt(3) : views[camera];
      }
    }
  }
}
