package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.detection.Scatter;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests that detections by chance are the same from a table, from the full model, and with a grid.
 */
class SightByChanceTest {
  /** A model whose confidence falls with distance, with waves on top if there are any. */
  private record Waves(double waves, boolean dependsOnBearing) implements DetectionModel {
    @Override
    public String name() {
      return "waves";
    }

    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      double wave = waves == 0 ? 0 : 0.2 * Math.cos(waves * distance);
      return size - distance / (4 * zoom.radius()) + wave;
    }

    @Override
    public Optional<Scatter> scatter() {
      return Optional.of(new Scatter(0.1, 0.2));
    }
  }

  private static Detection detection(String rule, double waves, boolean inFull) {
    return Detection.by(DetectionRule.parse(rule), "waves", new Waves(waves, inFull));
  }

  @Property(tries = 100, edgeCases = EdgeCasesMode.NONE)
  void detectsTheSameFromTableAndFullModel(
      @ForAll @IntRange(max = 2) int ruleNumber, @ForAll long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    World world = world(random, seed);
    String rule = List.of("chance", "chance:memory=3", "probability").get(ruleNumber);
    double waves = random.nextBoolean() ? 0 : random.nextDouble(5);
    Visibility visibility = Visibility.of(detection(rule, waves, false), seed);
    Sight table = new Sight(world, visibility);
    Sight full = new Sight(world, Visibility.of(detection(rule, waves, true), seed));
    int detected = 0;
    for (int step = 0; step < 5; step++) {
      table.beginStep(step);
      full.beginStep(step);
      for (int camera = 0; camera < world.cameras().count(); camera++) {
        for (int view = 0; view < world.cameras().views(camera); view++) {
          for (int target = 0; target < world.targets().count(); target++) {
            boolean detects = table.detects(camera, view, target);
            assertEquals(full.detects(camera, view, target), detects);
            assertEquals(confidence(world, visibility, step, camera, view, target) > 0, detects);
            assertEquals(
                full.chance(camera, view, target), table.chance(camera, view, target), 1e-8);
            detected += detects ? 1 : 0;
          }
        }
      }
      world.moveTargets();
    }
    assertTrue(detected > 0);
  }

  private static double confidence(
      World world, Visibility visibility, int step, int camera, int view, int target) {
    return visibility
        .at(world.cameras().zoom(camera, view), world.targets().size(target))
        .confidence(
            world.cameras().pose(camera),
            world.targets().x(target),
            world.targets().y(target),
            visibility.luck(step, camera, target),
            1);
  }

  @Property(tries = 40, edgeCases = EdgeCasesMode.NONE)
  void gridSeesAndExpectsTheSame(@ForAll long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    World world = world(random, seed);
    Visibility visibility = Visibility.of(detection("chance:phantoms=on", 0, false), seed);
    TestNetwork plain = new TestNetwork(world, visibility);
    TestNetwork binned = new TestNetwork(world, visibility, 1.5);
    for (TestNetwork network : List.of(plain, binned)) {
      network.beginStep(4);
      network.locate();
      network.observe();
    }
    for (int camera = 0; camera < plain.cameras(); camera++) {
      assertEquals(plain.detected(camera), binned.detected(camera));
      assertEquals(chances(plain, camera), chances(binned, camera));
    }
    for (int target = 0; target < plain.targets(); target++) {
      assertEquals(plain.coverage(target), binned.coverage(target));
    }
  }

  private static List<String> chances(TestNetwork network, int camera) {
    int[] targets = new int[network.targets()];
    double[] chances = new double[network.targets()];
    int count = network.chances(camera, targets, chances);
    List<String> pairs = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      pairs.add(targets[i] + " " + chances[i]);
    }
    pairs.sort(String::compareTo);
    return pairs;
  }

  /** Compares two million looks of one camera at eight still targets with the formula. */
  @ParameterizedTest
  @ValueSource(strings = {"chance", "chance:alpha=0.01,memory=5", "probability"})
  void frequenciesFollowTheFormula(String rule) {
    TestScenario scenario = new TestScenario().camera(TestScenario.camera("a", 0, 0, 0, 360, 8));
    for (int target = 0; target < 8; target++) {
      scenario.target(0, target);
    }
    World world = scenario.world();
    Sight sight = new Sight(world, Visibility.of(detection(rule, 0, false), 1));
    int steps = 250_000;
    double chiSquare = 0;
    for (int target = 0; target < 8; target++) {
      int detected = 0;
      for (int step = 0; step < steps; step++) {
        sight.beginStep(step);
        detected += sight.detects(0, 0, target) ? 1 : 0;
      }
      double chance = sight.chance(0, 0, target);
      double difference = detected - chance * steps;
      chiSquare += difference * difference / (steps * chance * (1 - chance));
    }
    int memory = DetectionRule.parse(rule).memory();
    assertTrue(chiSquare / memory < 26.1, "8 degrees of freedom, once in a thousand: " + chiSquare);
  }

  @Test
  void policiesMeetSameLuckForSameSeed() {
    List<String> widest = seen((network, views) -> views[0] = 1);
    List<String> turns = seen((network, views) -> views[0] = (int) (network.step() % 2));
    int compared = 0;
    for (int step = 1; step < widest.size(); step += 2) {
      assertEquals(widest.get(step), turns.get(step), "step " + step);
      compared += widest.get(step).contains("1") ? 1 : 0;
    }
    assertTrue(compared > 50);
  }

  private interface Decision {
    void decide(NetworkView network, int[] views);
  }

  private static List<String> seen(Decision decision) {
    ZoomPolicy policy =
        new ZoomPolicy() {
          @Override
          public String name() {
            return "test";
          }

          @Override
          public void decide(NetworkView network, int[] views) {
            decision.decide(network, views);
          }
        };
    World world =
        new TestScenario()
            .camera(TestScenario.camera("a", 0, 0, 0, 360, 8))
            .zooms(4, 8)
            .target(1, 2)
            .target(3, 4)
            .target(-2, 1)
            .world();
    List<String> seen = new ArrayList<>();
    StepListener listener =
        (network, coverage) ->
            seen.add("" + network.coverage(0) + network.coverage(1) + network.coverage(2));
    new Simulation(world, detection("chance", 0, false), policy, 9, List.of(listener)).run(200);
    return seen;
  }

  @Test
  void phantomsComeAtTheirRateAndCoverNothing() {
    World world =
        new TestScenario().camera(TestScenario.camera("a", 0, 0, 0, 360, 2)).target(8, 8).world();
    int[] sums = new int[2];
    StepListener listener =
        (network, coverage) -> {
          sums[0] += network.detected(0);
          sums[1] += network.coverage(0);
        };
    Detection detection = detection("chance:alpha=0.1,phantoms=on", 0, false);
    new Simulation(world, detection, new WidestPolicy(), 9, List.of(listener)).run(20_000);
    assertEquals(2000, sums[0], 140, "within 3.3 deviations");
    assertEquals(0, sums[1]);
  }

  @Test
  void expectedValuesEqualMeansOfDraws() {
    TestScenario scenario = new TestScenario();
    for (int i = 0; i < 4; i++) {
      scenario.camera(TestScenario.camera("c" + i, 2 * i - 4, 0, 0, 360, 8));
      scenario.target(i, 2 + i % 2);
    }
    RunCoverage coverage = new RunCoverage();
    Simulation simulation =
        new Simulation(
            scenario.world(),
            detection("chance", 0, false),
            new WidestPolicy(),
            3,
            List.of(coverage));
    simulation.run(20_000);
    assertEquals(coverage.expectedPerformance() / 20_000, coverage.meanKMin(), 0.02);
    assertEquals(coverage.expectedProportion0(), coverage.proportion0(), 0.01);
    assertEquals(coverage.expectedProportion1(), coverage.proportion1(), 0.01);
    assertEquals(coverage.expectedProportionK(), coverage.proportionK(), 0.01);
    assertEquals(coverage.expectedMeanK(), coverage.meanK(), 0.02);
    assertTrue(coverage.meanKMin() > 0.5 && coverage.proportion0() > 0.001);
    assertTrue(coverage.expectedProportion0() > 0.001);
    assertTrue(coverage.leastExpectedK() < coverage.expectedMeanK());
    assertTrue(coverage.leastChance() > 0 && coverage.leastChance() < 1);
  }

  private static World world(SplittableRandom random, long seed) {
    TestScenario scenario = new TestScenario().zooms(0.5, 3, 7.5);
    for (int camera = 0; camera < 4; camera++) {
      double angle = random.nextBoolean() ? 360 : random.nextDouble(20, 300);
      scenario.camera(
          TestScenario.camera(
              "c" + camera,
              random.nextDouble(-9, 9),
              random.nextDouble(-9, 9),
              random.nextDouble(360),
              angle,
              7.5));
    }
    for (int target = 0; target < 30; target++) {
      scenario.target(
          random.nextDouble(-9, 9), random.nextDouble(-9, 9), random.nextDouble(360), 0.4);
    }
    return scenario.world(seed);
  }
}
