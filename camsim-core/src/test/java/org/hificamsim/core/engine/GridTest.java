package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.detection.camsim.CamSimRangeDetection;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.ScenarioEvent.AddTarget;
import org.hificamsim.core.scenario.spec.ScenarioEvent.ChangeCamera;
import org.hificamsim.core.scenario.spec.ScenarioEvent.FailCamera;
import org.hificamsim.core.scenario.spec.ScenarioEvent.RemoveTarget;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;

/** Tests that a grid changes no observation, but only the time that looking takes. */
class GridTest {
  private static final int CAMERAS = 25;
  private static final int TARGETS = 40;
  private static final int STEPS = 12;

  /** Detects in rings, so that the detected distances have many intervals. */
  private record Rings(double waves) implements DetectionModel {
    @Override
    public String name() {
      return "rings";
    }

    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return size * Math.cos(waves * distance / zoom.radius());
    }
  }

  @Property(tries = 150, edgeCases = EdgeCasesMode.NONE)
  void gridObservesAsThePlainLoopDoes(
      @ForAll @IntRange(max = 3) int modelNumber, @ForAll long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    Detection detection = Detection.of(model(modelNumber, random));
    TestScenario scenario = scenario(random);
    double side = random.nextDouble(0.3, 12);
    World plain = scenario.world(seed);
    World binned = scenario.world(seed);
    TestNetwork expected = inOneList(plain, Visibility.of(detection));
    TestNetwork observed = new TestNetwork(binned, Visibility.of(detection), side);
    assertTrue(observed.grid().cells() > 1);
    for (int step = 0; step < STEPS; step++) {
      long drawn = random.nextLong();
      advance(plain, expected, step, new SplittableRandom(drawn));
      advance(binned, observed, step, new SplittableRandom(drawn));
      assertSame(expected, observed);
    }
  }

  private static TestNetwork inOneList(World world, Visibility visibility) {
    TestNetwork network = new TestNetwork(world, visibility, Double.POSITIVE_INFINITY);
    assertEquals(1, network.grid().cells());
    return network;
  }

  private static void advance(World world, TestNetwork network, int step, SplittableRandom random) {
    world.fireEvents(step);
    network.beginStep(step);
    network.locate();
    for (int camera = 0; camera < world.cameras().count(); camera++) {
      world.cameras().turnTo(camera, random.nextInt(world.cameras().views(camera)));
    }
    network.observe();
    world.moveTargets();
  }

  private static void assertSame(TestNetwork expected, TestNetwork observed) {
    for (int camera = 0; camera < expected.cameras(); camera++) {
      assertEquals(expected.detected(camera), observed.detected(camera), "camera " + camera);
    }
    for (int target = 0; target < expected.targets(); target++) {
      assertEquals(expected.coverage(target), observed.coverage(target), "target " + target);
    }
  }

  @Property(tries = 60, edgeCases = EdgeCasesMode.NONE)
  void masksEqualSingleDetections(@ForAll @IntRange(max = 3) int modelNumber, @ForAll long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    World world = scenario(random).world(seed);
    double side = random.nextBoolean() ? Double.POSITIVE_INFINITY : random.nextDouble(0.3, 12);
    Visibility visibility = Visibility.of(Detection.of(model(modelNumber, random)));
    TestNetwork network = new TestNetwork(world, visibility, side);
    world.fireEvents(STEPS);
    network.beginStep(STEPS);
    network.locate();
    long[] masks = new long[8];
    for (int camera = 0; camera < world.cameras().count(); camera++) {
      masks[0] = -1;
      network.detections(camera, masks, 2);
      for (int view = 0; view < world.cameras().views(camera); view++) {
        for (int target = 0; target < world.targets().count(); target++) {
          boolean marked = (masks[2 * view + target / 64] >>> target & 1) != 0;
          assertEquals(network.detects(camera, view, target), marked);
        }
      }
    }
  }

  @Test
  void seesTargetsAtReachAcrossCellBorders() {
    TestScenario scenario =
        new TestScenario()
            .camera(TestScenario.camera("a", 0, 0, 45, 360, 5))
            .target(5, 0)
            .target(0, 5)
            .target(-5, 0)
            .target(0, -5);
    for (int beyond = 0; beyond < 20; beyond++) {
      scenario.target(9, 9); // allows a grid of 64 cells
    }
    World world = scenario.world();
    for (DetectionModel model :
        List.of(new GeometricDetection(), new CamSimVisibilityDetection())) {
      Visibility visibility = Visibility.of(Detection.of(model));
      TestNetwork network = new TestNetwork(world, visibility, 2.5);
      assertEquals(64, network.grid().cells());
      network.locate();
      network.observe();
      assertEquals(4, network.detected(0), model.name());
    }
  }

  private static int cells(World world) {
    Visibility visibility = Visibility.of(Detection.of(new GeometricDetection()));
    return new TestNetwork(world, visibility).grid().cells();
  }

  @Test
  void onlyBigWorldsHaveAGrid() {
    assertEquals(1, cells(randomPlaces(20, 20, 100).world()));
    assertTrue(cells(randomPlaces(300, 200, 100).world()) > 100);
    assertEquals(1, cells(randomPlaces(300, 200, 5).world()));
  }

  private static TestScenario randomPlaces(int cameras, int targets, double field) {
    SplittableRandom random = new SplittableRandom(3);
    TestScenario scenario = new TestScenario().field(0, field, 0, field).zooms(2, 4);
    for (int camera = 0; camera < cameras; camera++) {
      scenario.camera(random.nextDouble(field), random.nextDouble(field));
    }
    for (int target = 0; target < targets; target++) {
      scenario.target(
          random.nextDouble(field), random.nextDouble(field), random.nextDouble(360), 1);
    }
    return scenario;
  }

  private static DetectionModel model(int modelNumber, SplittableRandom random) {
    return switch (modelNumber) {
      case 0 -> new CamSimRangeDetection();
      case 1 -> new GeometricDetection();
      case 2 -> new CamSimVisibilityDetection();
      default -> new Rings(random.nextDouble(20));
    };
  }

  /**
   * Returns a random scenario with ranges or a zoom list, sectors, targets on borders and outside,
   * and cameras and targets that events add.
   */
  private static TestScenario scenario(SplittableRandom random) {
    TestScenario scenario = new TestScenario();
    if (random.nextBoolean()) {
      scenario.zooms(0.5, 3, 7.5);
    }
    for (int camera = 0; camera < CAMERAS; camera++) {
      double angle = random.nextInt(3) == 0 ? random.nextDouble(1, 360) : 360;
      double range = random.nextInt(5) == 0 ? 18 : random.nextDouble(4);
      scenario.camera(
          TestScenario.camera(
              "c" + camera,
              coordinate(random),
              coordinate(random),
              random.nextDouble(360),
              angle,
              range));
    }
    double[] sizes = {0.3, 0.66, 2};
    for (int target = 0; target < TARGETS; target++) {
      double x = coordinate(random) * (random.nextInt(9) == 0 ? 1.5 : 1);
      double heading = random.nextDouble(360);
      scenario.target(
          TestScenario.target(target, x, coordinate(random), heading, random.nextDouble(3))
              .withSize(sizes[random.nextInt(3)]));
    }
    return scenario.events(events(random));
  }

  private static ScenarioEvent[] events(SplittableRandom random) {
    List<ScenarioEvent> events = new ArrayList<>();
    for (int step = 1; step < STEPS; step++) {
      String camera = "c" + random.nextInt(CAMERAS);
      double x = coordinate(random);
      events.add(new ChangeCamera(step, camera, x, -1, 5, -1, random.nextDouble(9)));
      events.add(new FailCamera(step, "c" + random.nextInt(CAMERAS), 1 + random.nextInt(3)));
      events.add(new RemoveTarget(step, random.nextInt(TARGETS)));
      events.add(new AddTarget(step, TestScenario.target(TARGETS + step, x, 0, 10, 1)));
    }
    return events.toArray(ScenarioEvent[]::new);
  }

  private static double coordinate(SplittableRandom random) {
    return random.nextInt(3) == 0 ? random.nextInt(-10, 11) : random.nextDouble(-10, 10);
  }
}
