package org.hificamsim.core.engine;

import static org.hificamsim.core.TestScenario.camera;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.InputException;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.policy.OraclePolicy;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.DutyCycle;
import org.hificamsim.core.scenario.spec.ProcessingBudget;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class LateDetectionsTest {
  /**
   * Returns a scenario of three targets that stand 1, 2 and 3 m from a camera; the first is the
   * farthest.
   */
  private static TestScenario threeTargets(int budget) {
    return new TestScenario()
        .order(StepOrder.COVERAGE)
        .with(Scenario.PROCESSING, new ProcessingBudget(budget))
        .target(3, 0)
        .target(1, 0)
        .target(2, 0);
  }

  private static Simulation simulation(TestScenario scenario, ZoomPolicy policy) {
    Detection detection = Detection.of(new GeometricDetection());
    return new Simulation(scenario.world(), detection, policy, 0, List.of());
  }

  /** The coverage of each target in each step, a word for each step. */
  private static String coverages(TestScenario scenario, int steps) {
    Simulation simulation = simulation(scenario, new WidestPolicy());
    List<String> words = new ArrayList<>();
    for (int step = 0; step < steps; step++) {
      simulation.step();
      StringBuilder word = new StringBuilder();
      for (int target = 0; target < simulation.network().targets(); target++) {
        word.append(simulation.network().coverage(target));
      }
      words.add(word.toString());
    }
    return String.join(" ", words);
  }

  @ParameterizedTest
  @CsvSource({"1, 010 111 111", "2, 011 111 111", "3, 111 111 111"})
  void nearestTargetsAreKnownAtOnceAndOthersAStepLater(int budget, String expected) {
    assertEquals(expected, coverages(threeTargets(budget).camera(0, 0), 3));
  }

  @Test
  void cameraThatSeesNothingDropsLateDetections() {
    CameraSpec half = new CameraSpec("half", 0, 0, 5).with(CameraSpec.DUTY, DutyCycle.parse("1/2"));
    assertEquals("010 000 010 000", coverages(threeTargets(1).camera(half), 4));
  }

  @Test
  void targetThatVanishedIsNotKnownLater() {
    TestScenario scenario =
        threeTargets(1).camera(0, 0).events(new ScenarioEvent.RemoveTarget(1, 0));
    assertEquals("010 011 011", coverages(scenario, 3));
  }

  /** A target leaves the camera's sight at 5 m: it is known a step late, where it was then. */
  @Test
  void lateTargetIsWhereItWasDetected() {
    TestScenario scenario =
        threeTargets(1)
            .camera(camera("c", 0, 0, 0, 360, 5))
            .target(TestScenario.target(3, 4.5, 0, 90, 1));
    Simulation simulation = simulation(scenario, new WidestPolicy());
    simulation.run(2);
    OracleView network = simulation.network();
    assertTrue(network.sees(0, 3));
    assertEquals(4.5, network.distance(0, 3));
    assertEquals(Math.PI / 2, network.bearing(0, 3), 1e-12);
    assertEquals(1, network.confidence(0, 3));
    assertEquals(1, network.seenConfidence(0, 3, 4.5));
    SeenPairs pairs = new SeenPairs();
    network.findSeen(pairs);
    assertEquals(4, pairs.count());
    assertEquals(4.5, pairs.distance(3));
    simulation.run(1);
    assertFalse(network.sees(0, 3));
    assertEquals(Double.NaN, network.distance(0, 3));
  }

  @Test
  void boundKnowsAllDetectionsAtOnce() {
    class Bound implements OraclePolicy {
      @Override
      public String name() {
        return "bound";
      }

      @Override
      public void decide(OracleView network, int[] views) {}
    }
    Simulation simulation = simulation(threeTargets(1).camera(0, 0), new Bound());
    simulation.run(1);
    assertEquals(3, simulation.network().detected(0));
  }

  /** The views and detections of a run among moving targets, as text. */
  private static String run(int budget, int count, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    TestScenario scenario = threeTargets(budget).zooms(2, 4, 8);
    for (int i = 0; i < count; i++) {
      scenario.camera(random.nextDouble(-9, 9), random.nextDouble(-9, 9));
      scenario.target(
          random.nextDouble(-9, 9), random.nextDouble(-9, 9), random.nextDouble(0, 360), 0.7);
    }
    StringBuilder text = new StringBuilder();
    Detection detection = Detection.of(new GeometricDetection());
    StepListener writer = (network, coverage) -> write(network, text);
    new Simulation(scenario.world(), detection, new WidestPolicy(), 0, List.of(writer)).run(30);
    return text.toString();
  }

  /** Writes how targets are covered, which has to agree with the pairs that cameras see. */
  private static void write(OracleView network, StringBuilder text) {
    SeenPairs pairs = new SeenPairs();
    network.findSeen(pairs);
    int[] known = new int[network.targets()];
    for (int pair = 0; pair < pairs.count(); pair++) {
      int camera = pairs.camera(pair);
      int target = pairs.target(pair);
      known[target]++;
      assertTrue(network.sees(camera, target));
      text.append(network.seenConfidence(camera, target, pairs.distance(pair))).append(' ');
      text.append(network.confidence(camera, target)).append(' ');
      text.append(network.bearing(camera, target)).append(' ');
    }
    for (int target = 0; target < network.targets(); target++) {
      assertEquals(network.coverage(target), known[target]);
      text.append(network.coverage(target)).append(' ');
    }
    for (int camera = 0; camera < network.cameras(); camera++) {
      text.append(network.detected(camera)).append(' ');
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 5, 70})
  void budgetForAllTargetsChangesNothing(int count) {
    String unlimited = run(Integer.MAX_VALUE, count, count);
    assertEquals(unlimited, run(count + 3, count, count));
    assertNotEquals(unlimited, run(1, count, count));
  }

  @ParameterizedTest
  @ValueSource(strings = {"0", "-1", "1.5", "x", "", "01", "9999999999"})
  void rejectsInvalidBudgets(String text) {
    InputException fault = assertThrows(InputException.class, () -> ProcessingBudget.parse(text));
    assertTrue(fault.getMessage().contains("processing is '" + text + "'"), fault.getMessage());
  }
}
