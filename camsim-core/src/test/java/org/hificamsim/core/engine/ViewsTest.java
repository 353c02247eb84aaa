package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.detection.Scatter;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Occlusion;
import org.hificamsim.core.scenario.spec.OpticsLaw;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;

/**
 * Tests that views of cameras with optics equal a direct evaluation past obstacles, with and
 * without a grid.
 */
class ViewsTest {
  /** A model whose confidence falls with distance and, optionally, off the axis. */
  private record Falling(boolean dependsOnBearing) implements DetectionModel {
    @Override
    public String name() {
      return "falling";
    }

    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      double aside = dependsOnBearing && offAxis > 0.1 ? 0.3 : 0;
      return size / (1 + distance * zoom.viewingAngle() / 8) - aside;
    }

    @Override
    public Optional<Scatter> scatter() {
      return Optional.of(new Scatter(0.1, 0.2));
    }
  }

  @Property(tries = 300, edgeCases = EdgeCasesMode.NONE)
  void detectsAsPipelineDoesOneByOne(@ForAll long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    World world = world(random, seed);
    Visibility visibility = Visibility.of(detection(random), seed);
    TestNetwork network = new TestNetwork(world, visibility);
    int words = (world.targets().count() + 63) / 64;
    for (int step = 0; step < 3; step++) {
      world.fireEvents(step);
      network.beginStep(step);
      network.locate();
      for (int camera = 0; camera < world.cameras().count(); camera++) {
        long[] masks = new long[world.cameras().views(camera) * words];
        network.detections(camera, masks, words);
        for (int view = 0; view < world.cameras().views(camera); view++) {
          for (int target = 0; target < world.targets().count(); target++) {
            boolean expected = detectsDirectly(world, visibility, step, camera, view, target);
            assertEquals(expected, network.detects(camera, view, target));
            assertEquals(expected, (masks[view * words + (target >> 6)] >> target & 1) == 1);
          }
        }
      }
      world.moveTargets();
    }
  }

  /** Evaluates one pair directly from the scenario. */
  private static boolean detectsDirectly(
      World world, Visibility visibility, int step, int camera, int view, int target) {
    Pose pose = world.cameras().pose(camera);
    double x = world.targets().x(target);
    double y = world.targets().y(target);
    Scenario scenario = world.scenario();
    double through = new Obstacles(scenario.obstacles()).transmittance(pose.x(), pose.y(), x, y);
    if (scenario.occlusion() == Occlusion.TARGETS && isHidden(world, pose, target)) {
      through = 0;
    }
    double pan = world.cameras().pan(camera, view);
    Pose turned = pan == 0 ? pose : Pose.of(pose.x(), pose.y(), pose.heading() + pan);
    double luck = visibility.luck(step, camera, target);
    ZoomLevel zoom = world.cameras().zoom(camera, view);
    double size = world.targets().size(target);
    return visibility.at(zoom, size).confidence(turned, x, y, luck, through) > 0;
  }

  private static boolean isHidden(World world, Pose pose, int target) {
    double x = world.targets().x(target);
    double y = world.targets().y(target);
    for (int other = 0; other < world.targets().count(); other++) {
      double otherX = world.targets().x(other);
      double otherY = world.targets().y(other);
      Obstacle disc = new Obstacle.Pillar(otherX, otherY, world.targets().width(other) / 2, 0);
      if (other != target
          && pose.squaredDistance(otherX, otherY) < pose.squaredDistance(x, y)
          && disc.touches(pose.x(), pose.y(), x, y)
          && !disc.contains(pose.x(), pose.y())) {
        return true;
      }
    }
    return false;
  }

  @Property(tries = 60, edgeCases = EdgeCasesMode.NONE)
  void gridSeesTheSame(@ForAll long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    World world = world(random, seed);
    Visibility visibility = Visibility.of(detection(random), seed);
    for (int camera = 0; camera < world.cameras().count(); camera++) {
      world.cameras().jumpTo(camera, random.nextInt(world.cameras().views(camera)));
    }
    TestNetwork plain = new TestNetwork(world, visibility);
    TestNetwork binned = new TestNetwork(world, visibility, 1.5);
    for (TestNetwork network : List.of(plain, binned)) {
      network.beginStep(2);
      network.locate();
      network.observe();
    }
    for (int camera = 0; camera < plain.cameras(); camera++) {
      assertEquals(plain.detected(camera), binned.detected(camera));
    }
    for (int target = 0; target < plain.targets(); target++) {
      assertEquals(plain.coverage(target), binned.coverage(target));
    }
  }

  @Property(tries = 100, edgeCases = EdgeCasesMode.NONE)
  void dominatingViewDetectsAllOfTheOther(@ForAll long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    World world = world(random, seed);
    TestNetwork network = new TestNetwork(world, Visibility.of(detection(random), seed));
    network.beginStep(0);
    network.locate();
    for (int camera = 0; camera < network.cameras(); camera++) {
      for (int view = 0; view < network.views(camera); view++) {
        for (int other = 0; other < network.views(camera); other++) {
          for (int target = 0; network.dominates(camera, view, other) && target < 5; target++) {
            assertTrue(
                network.detects(camera, view, target) || !network.detects(camera, other, target));
          }
        }
      }
    }
  }

  @Test
  void seesTargetAtItsBearing() {
    OpticsSpec optics = lens(List.of(60.0), List.of(-30.0, 0.0, 30.0));
    World world =
        new TestScenario()
            .camera(TestScenario.camera("a", 0, 0, 90, optics))
            .target(4, -1)
            .target(-4, 0)
            .world();
    TestNetwork network = new TestNetwork(world, Visibility.of(geometric()));
    network.beginStep(0);
    network.locate();
    assertEquals(1, network.view(0), "ahead at first");
    assertTrue(network.sees(0, 0));
    assertFalse(network.sees(0, 1));
    assertEquals(Math.atan2(1, 4), network.bearing(0, 0), 1e-12, "to the right is positive");
    assertEquals(Math.hypot(4, 1), network.distance(0, 0), 1e-12);
    assertTrue(Double.isNaN(network.bearing(0, 1)));
    world.cameras().jumpTo(0, 2);
    assertEquals(Math.atan2(1, 4) - Math.toRadians(30), network.bearing(0, 0), 1e-12);
  }

  private static Detection geometric() {
    return Detection.of(
        new DetectionModel() {
          @Override
          public String name() {
            return "all";
          }

          @Override
          public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
            return 1;
          }
        });
  }

  private static Detection detection(SplittableRandom random) {
    String rule = List.of("threshold", "chance", "probability").get(random.nextInt(3));
    return Detection.by(DetectionRule.parse(rule), "falling", new Falling(random.nextInt(3) == 0));
  }

  private static World world(SplittableRandom random, long seed) {
    TestScenario scenario = new TestScenario().zooms(2, 4, 7);
    List<OpticsSpec> optics = List.of(optics(random), optics(random));
    for (int camera = 0; camera < 3; camera++) {
      double x = coordinate(random);
      double y = coordinate(random);
      double heading = random.nextDouble(360);
      scenario.camera(
          random.nextInt(4) == 0
              ? TestScenario.camera("c" + camera, x, y, heading, 20 + random.nextDouble(340), 5)
              : TestScenario.camera("c" + camera, x, y, heading, optics.get(camera % 2)));
    }
    for (int target = 0; target < 6; target++) {
      double size = random.nextBoolean() ? 0.66 : random.nextDouble(0.1, 2);
      scenario.target(
          TestScenario.target(
                  target, coordinate(random), coordinate(random), random.nextInt(360), 0.7)
              .withSize(size));
    }
    scenario.events(
        new ScenarioEvent.ChangeCamera(
            2, "c0", coordinate(random), coordinate(random), 45, -1, -1));
    return scenario
        .with(Scenario.OBSTACLES, obstacles(random))
        .with(Scenario.OCCLUSION, random.nextInt(3) == 0 ? Occlusion.TARGETS : Occlusion.NONE)
        .world(seed);
  }

  /** Returns a lattice coordinate, so that lines of sight graze corners and run along walls. */
  private static double coordinate(SplittableRandom random) {
    return random.nextInt(-9, 10);
  }

  private static List<Obstacle> obstacles(SplittableRandom random) {
    List<Obstacle> obstacles = new ArrayList<>();
    int count = random.nextInt(6);
    for (int i = 0; i < count; i++) {
      obstacles.add(obstacle(random, random.nextInt(3) == 0 ? 0.8 : 0));
    }
    return obstacles;
  }

  private static Obstacle obstacle(SplittableRandom random, double transmittance) {
    double x = coordinate(random);
    double y = coordinate(random);
    return switch (random.nextInt(3)) {
      case 0 ->
          new Obstacle.Wall(
              x, y, x + random.nextInt(1, 6), y + random.nextInt(-3, 4), transmittance);
      case 1 -> new Obstacle.Pillar(x, y, random.nextDouble(0.2, 2), transmittance);
      default ->
          new Obstacle.Polygon(
              List.of(new Point(x, y), new Point(x + 2, y), new Point(x + 1, y + 2)),
              transmittance);
    };
  }

  private static OpticsSpec optics(SplittableRandom random) {
    OpticsLaw law = OpticsLaw.values()[random.nextInt(3)];
    List<Double> pans = random.nextBoolean() ? List.of(0.0) : List.of(-40.0, 0.0, 40.0);
    return new OpticsSpec("optics" + random.nextInt())
        .with(OpticsSpec.LAW, law)
        .with(OpticsSpec.PIXELS, 640)
        .with(
            OpticsSpec.ANGLES_OF_VIEW,
            law == OpticsLaw.ROUND ? List.of() : List.of(10.0, 30.0, 90.0))
        .with(
            OpticsSpec.REACH, law == OpticsLaw.CONSTANT_AREA ? Optional.of(12.0) : Optional.empty())
        .with(OpticsSpec.PANS, pans);
  }

  private static OpticsSpec lens(List<Double> angles, List<Double> pans) {
    return new OpticsSpec("lens")
        .with(OpticsSpec.ANGLES_OF_VIEW, angles)
        .with(OpticsSpec.PANS, pans);
  }
}
