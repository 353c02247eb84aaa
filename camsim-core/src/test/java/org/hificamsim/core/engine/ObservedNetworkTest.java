package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.scenario.spec.ScenarioEvent.ChangeCamera;
import org.hificamsim.core.scenario.spec.ScenarioEvent.RemoveTarget;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the answers of the network within a step, for each kind of sight. */
class ObservedNetworkTest {
  private static final Obstacle HALF_LIGHT = new Obstacle.Wall(-9, 1, 9, 1, 0.5);

  /** The same value everywhere. */
  private record Constant(double value, boolean dependsOnBearing) implements DetectionModel {
    @Override
    public String name() {
      return "constant";
    }

    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return value;
    }
  }

  /** Detects everything at levels of more than 6 m, and nothing at others. */
  private record Wide() implements DetectionModel {
    @Override
    public String name() {
      return "wide";
    }

    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return zoom.radius() > 6 ? 1 : 0;
    }
  }

  /** Detects only between 2 m and 4 m. */
  private record Ring() implements DetectionModel {
    @Override
    public String name() {
      return "ring";
    }

    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return distance >= 2 && distance <= 4 ? 1 : 0;
    }
  }

  /** Both rules detect the same with this model, but in different ways. */
  @ParameterizedTest
  @ValueSource(strings = {"threshold", "probability"})
  void detectsTargetsInReachAndAngle(String rule) {
    World world =
        new TestScenario()
            .camera(TestScenario.camera("a", 0, 0, 0, 90, 5))
            .target(0, 3)
            .target(0, -5)
            .target(0, -6)
            .target(0, 2)
            .events(new RemoveTarget(0, 3))
            .world();
    TestNetwork network = network(world, certain(rule));
    boolean[] detected = {true, false, false, false};
    for (int target = 0; target < 4; target++) {
      assertEquals(detected[target], network.detects(0, 0, target), "target " + target);
      assertEquals(detected[target] ? 1 : 0, network.chance(0, 0, target), "target " + target);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"threshold", "probability"})
  void movedCameraSeesFromNewPosition(String rule) {
    World world =
        new TestScenario()
            .camera(0, 0)
            .target(0, 9)
            .events(new ChangeCamera(1, "c0", 0, 3, -1, -1, 7))
            .world();
    Detection detection = Detection.by(DetectionRule.parse(rule), "wide", new Wide());
    TestNetwork network = network(world, detection);
    int before = network.revision();
    assertFalse(network.detects(0, 0, 0));
    world.fireEvents(1);
    network.beginStep(1);
    assertTrue(network.detects(0, 0, 0));
    assertEquals(7, network.zoom(0, 0).radius());
    assertNotEquals(before, network.revision());
  }

  @ParameterizedTest
  @CsvSource({"threshold, false", "threshold, true", "probability, false"})
  void halfTransmittanceHalvesConfidence(String rule, boolean bearing) {
    World world = new TestScenario().camera(0, 0).target(0, 3).obstacles(HALF_LIGHT).world();
    Detection detection =
        Detection.by(DetectionRule.parse(rule), "constant", new Constant(0.7, bearing));
    TestNetwork network = network(world, detection);
    assertEquals(0.35, network.confidence(0, 0), 1e-12);
    assertEquals(0.35, network.seenConfidence(0, 0, 3), 1e-8);
  }

  @ParameterizedTest
  @CsvSource({"0.3, 1", "0.4, 0"})
  void comparesAttenuatedValueWithThreshold(double threshold, int seen) {
    World world = new TestScenario().camera(0, 0).target(0, 3).obstacles(HALF_LIGHT).world();
    TestNetwork network = network(world, new Detection(new Constant(0.7, false), threshold));
    network.observe();
    assertEquals(seen, network.detected(0));
    assertEquals(seen == 1, network.detects(0, 0, 0));
  }

  @Test
  void ignoresTargetsInBlindZoneNearby() {
    World world = new TestScenario().camera(0, 0).target(0, 1).target(0, 3).target(0, 0).world();
    TestNetwork network = network(world, Detection.of(new Ring()));
    network.observe();
    assertEquals(1, network.detected(0));
    assertEquals(List.of(1), found(network));
    assertEquals(4, network.reach(0, 0), 1e-8);
  }

  /**
   * The angle is bracketed first, and the model detects nothing at the lower end of the bracket.
   */
  @Test
  void evaluatesModelAtExactAngleIfUndecided() {
    World world = new TestScenario().camera(0, 0).target(1, 2).world();
    double angle = world.cameras().pose(0).offAxis(1, 2);
    DetectionModel offAxisModel =
        new DetectionModel() {
          @Override
          public String name() {
            return "aside";
          }

          @Override
          public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
            return offAxis >= angle ? 1 : 0;
          }

          @Override
          public boolean dependsOnBearing() {
            return true;
          }
        };
    assertTrue(network(world, Detection.of(offAxisModel)).detects(0, 0, 0));
  }

  @Test
  void detectsTargetAtTheCamera() {
    TestNetwork network =
        network(new TestScenario().camera(0, 0).target(0, 0).world(), certain("threshold"));
    assertTrue(network.detects(0, 0, 0));
    assertEquals(List.of(0), found(network));
  }

  @Test
  void omitsTargetsBehindCamera() {
    World world =
        new TestScenario()
            .camera(TestScenario.camera("a", 0, 0, 0, 90, 5))
            .target(0, -2)
            .target(0, 2)
            .world();
    assertEquals(List.of(1), found(network(world, certain("threshold"))));
  }

  /** Returns the targets that the first camera sees. */
  private static List<Integer> found(TestNetwork network) {
    SeenPairs pairs = new SeenPairs();
    network.findSeen(pairs);
    return IntStream.range(0, pairs.count())
        .filter(pair -> pairs.camera(pair) == 0)
        .mapToObj(pairs::target)
        .toList();
  }

  @Test
  void findsAllSeenTargets() {
    World world = new TestScenario().camera(0, 0).target(0, 1).target(0, 2).target(3, 0).world();
    assertEquals(List.of(0, 1, 2), found(network(world, certain("threshold"))));
  }

  /** Writes two words per view over old contents, and leaves later words unchanged. */
  @ParameterizedTest
  @CsvSource({"threshold, 100", "threshold, 3", "probability, 100", "probability, 3"})
  void marksDetectionsOfEachView(String rule, double side) {
    World world = crowd().world();
    Visibility visibility = Visibility.of(certain(rule));
    TestNetwork network = new TestNetwork(world, visibility, side);
    assertEquals(side < 20, network.grid().cells() > 1);
    begin(world, network);
    long[] masks = new long[5];
    Arrays.fill(masks, -1);
    network.detections(0, masks, 2);
    int marked = 0;
    for (int view = 0; view < 2; view++) {
      for (int target = 0; target < network.targets(); target++) {
        boolean mark = (masks[2 * view + target / 64] >>> target & 1) != 0;
        assertEquals(network.detects(0, view, target), mark, view + " " + target);
        marked += mark ? 1 : 0;
      }
    }
    assertEquals(4 + 32, marked);
    assertEquals(-1, masks[4]);
  }

  @Test
  void marksTargetsDetectedBySomeView() {
    TestNetwork network = network(crowd().world(), certain("threshold"));
    boolean[] coverable = new boolean[network.targets() + 1];
    Arrays.fill(coverable, true);
    network.markCoverable(coverable);
    for (int target = 0; target < network.targets(); target++) {
      boolean expected = network.detects(0, 0, target) || network.detects(0, 1, target);
      assertEquals(expected, coverable[target], "target " + target);
    }
    assertTrue(coverable[network.targets()], "behind the last");
  }

  /** A camera with two levels, and rows of 100 targets that extend beyond both. */
  private static TestScenario crowd() {
    TestScenario scenario = new TestScenario().zooms(3, 6).camera(0, 0);
    for (int target = 0; target < 100; target++) {
      scenario.target(target % 10 * 2 - 9, target / 10 * 2 - 9);
    }
    return scenario;
  }

  @Test
  void widerLevelOfSameSectorDominates() {
    World world =
        new TestScenario()
            .zooms(2, 4)
            .camera(TestScenario.camera("a", 0, 0, 0, 90, 5))
            .target(0, 1)
            .world();
    TestNetwork network = network(world, certain("threshold"));
    assertTrue(network.dominates(0, 1, 0));
    assertFalse(network.dominates(0, 0, 1));
  }

  @Test
  void reportsTargetSize() {
    World world =
        new TestScenario()
            .camera(0, 0)
            .target(TestScenario.target(0, 1, 1, 0, 0).withSize(1.5))
            .world();
    assertEquals(1.5, network(world, certain("threshold")).targetSize(0));
  }

  private static Detection certain(String rule) {
    return Detection.by(DetectionRule.parse(rule), "geometric", new GeometricDetection());
  }

  private static TestNetwork network(World world, Detection detection) {
    TestNetwork network = new TestNetwork(world, Visibility.of(detection));
    begin(world, network);
    return network;
  }

  private static void begin(World world, TestNetwork network) {
    world.fireEvents(0);
    network.beginStep(0);
    network.locate();
  }
}
