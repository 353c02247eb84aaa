package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
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
import org.hificamsim.core.detection.camsim.CamSimStandardDetection;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.scenario.spec.ScenarioEvent.ChangeCamera;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that tabulated distances detect the same as the full model. */
class SightTest {
  private static final int CAMERAS = 4;
  private static final int TARGETS = 60;

  /**
   * A model whose confidence falls and rises with distance, with the target's size and with the
   * zoom.
   */
  private record Rings(double waves, double phase) implements DetectionModel {
    @Override
    public String name() {
      return "rings";
    }

    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return size * Math.cos(phase + waves * distance / zoom.radius()) + zoom.radius() / 20;
    }
  }

  /** A model that is evaluated for each target instead of being tabulated. */
  private record FullModel(DetectionModel model) implements DetectionModel {
    @Override
    public String name() {
      return model.name();
    }

    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return model.confidence(size, distance, offAxis, zoom);
    }

    @Override
    public boolean dependsOnBearing() {
      return true;
    }
  }

  @Property(tries = 80, edgeCases = EdgeCasesMode.NONE)
  void tabulatedModelDetectsAsTheFullModel(
      @ForAll @IntRange(max = 4) int modelNumber, @ForAll long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    World world = randomWorld(random);
    Detection detection = new Detection(model(modelNumber, random), random.nextDouble(0.05, 0.7));
    Sight tabulated = new Sight(world, Visibility.of(detection));
    Sight full = new Sight(world, withFullModel(detection));
    assertSame(world, tabulated, full);
  }

  @Property(tries = 200, edgeCases = EdgeCasesMode.NONE)
  void lookSeesTargetsDetectedOneByOne(
      @ForAll @IntRange(max = 4) int modelNumber, @ForAll long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    World world = random.nextBoolean() ? randomWorld(random) : randomWorld(random, 0.66);
    Detection detection = new Detection(model(modelNumber, random), random.nextDouble(0.05, 0.7));
    assertLooksAsItDetects(world, new Sight(world, Visibility.of(detection)));
    assertLooksAsItDetects(world, new Sight(world, withFullModel(detection)));
  }

  /** One camera is offline, one is at another level, and one target is on a border. */
  @Test
  void lookOfAllCamerasEqualsSingleDetections() {
    TestScenario scenario = new TestScenario().zooms(2, 5);
    for (int camera = 0; camera < 5; camera++) {
      scenario.camera(TestScenario.camera("c" + camera, camera - 2, camera % 2, 0, 360, 5));
    }
    SplittableRandom random = new SplittableRandom(8);
    for (int target = 0; target < 70; target++) {
      scenario.target(random.nextDouble(-9, 9), random.nextDouble(-9, 9));
    }
    World world = scenario.target(3, 0).world();
    world.cameras().turnTo(1, 0);
    world.switchCamera(3, false);
    Sight sight = new Sight(world, Visibility.of(Detection.of(new GeometricDetection())));
    sight.locate();
    int targets = world.targets().count();
    int[] detected = {-1, -1, -1, -1, -1};
    int[] counts = new int[targets];
    sight.look(detected, counts, new long[targets + 1]);
    SeenPairs found = new SeenPairs();
    sight.findSeen(found);
    int pair = 0;
    int[] expected = new int[targets];
    for (int camera = 0; camera < 5; camera++) {
      int before = pair;
      for (int i = 0; i < targets; i++) {
        if (camera != 3 && sight.detects(camera, world.cameras().view(camera), i)) {
          expected[i]++;
          assertEquals(camera, found.camera(pair));
          assertEquals(i, found.target(pair++));
        }
      }
      assertEquals(pair - before, detected[camera]);
    }
    assertEquals(pair, found.count());
    assertArrayEquals(expected, counts);
    assertTrue(pair > 50 && detected[1] > 0 && detected[1] < detected[0], pair + " seen");
  }

  /** Writes three words per view, and leaves the other words of the array unchanged. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void marksTargetsBeyondTheFirstSixtyFour(boolean withFullModel) {
    TestScenario scenario =
        new TestScenario().camera(TestScenario.camera("a", 0, 0, 0, 200, 5)).zooms(2, 5);
    for (int target = 0; target < 150; target++) {
      scenario.target(target % 13 - 6, target % 7 - 3);
    }
    World world = scenario.world();
    Detection detection = Detection.of(new GeometricDetection());
    Sight sight =
        new Sight(world, withFullModel ? withFullModel(detection) : Visibility.of(detection));
    sight.locate();
    long[] masks = new long[7];
    masks[6] = 5;
    sight.detections(0, masks, 3);
    int seen = 0;
    for (int view = 0; view < 2; view++) {
      for (int target = 0; target < 150; target++) {
        boolean marked = (masks[3 * view + target / 64] >>> target % 64 & 1) != 0;
        assertEquals(sight.detects(0, view, target), marked, view + " " + target);
        seen += marked ? 1 : 0;
      }
    }
    assertTrue(seen > 50, seen + " seen");
    assertEquals(5, masks[6]);
    assertEquals(0, (masks[2] | masks[5]) >>> 22);
  }

  @Test
  void seesUpToTheExactBorder() {
    TestScenario scenario = new TestScenario().camera(TestScenario.camera("a", 0, 0, 0, 360, 5));
    // The squared distances of the last two exceed 25 by one and two units in the last place; the
    // root of the first of them is rounded to 5.
    double[][] positions = {{0, 0}, {3, 4}, {0x1p-24, 5}, {0x1.8p-24, 5}};
    for (double[] position : positions) {
      scenario.target(position[0], position[1]);
    }
    World world = scenario.zooms(5).world();
    Sight sight = new Sight(world, Visibility.of(Detection.of(new GeometricDetection())));
    int[] counts = new int[positions.length];
    int[] detected = new int[1];
    sight.locate();
    sight.look(detected, counts, new long[positions.length + 1]);
    assertEquals(3, detected[0]);
    assertArrayEquals(new int[] {1, 1, 1, 0}, counts);
  }

  @Test
  void detectsAsTheFullModelAfterCamerasChange() {
    World world =
        new TestScenario()
            .camera(TestScenario.camera("a", 0, 0, 0, 90, 3))
            .camera(TestScenario.camera("b", 1, 1, 0, 360, 3))
            .target(0, 5)
            .target(4, 0)
            .target(-4, 0)
            .events(
                new ChangeCamera(1, "a", -1, -1, 90, -1, 9),
                new ChangeCamera(2, "a", -1, -1, -1, 360, -1),
                new ChangeCamera(3, "b", 5, 5, -1, 10, 8))
            .world();
    Detection detection = Detection.of(new GeometricDetection());
    Sight tabulated = new Sight(world, Visibility.of(detection));
    Sight full = new Sight(world, withFullModel(detection));
    int[] seenByA = {0, 1, 3, 3};
    for (int step = 0; step < 4; step++) {
      world.fireEvents(step);
      tabulated.beginStep(0);
      full.beginStep(0);
      assertSame(world, tabulated, full);
      int seen = 0;
      for (int target = 0; target < 3; target++) {
        seen += tabulated.detects(0, 0, target) ? 1 : 0;
      }
      assertEquals(seenByA[step], seen, "step " + step);
    }
  }

  private static Visibility withFullModel(Detection detection) {
    return Visibility.of(new Detection(new FullModel(detection.model()), detection.threshold()));
  }

  private static void assertSame(World world, Sight tabulated, Sight full) {
    for (int camera = 0; camera < world.cameras().count(); camera++) {
      for (int view = 0; view < world.cameras().views(camera); view++) {
        for (int target = 0; target < world.targets().count(); target++) {
          assertEquals(
              full.detects(camera, view, target),
              tabulated.detects(camera, view, target),
              "camera %s view %s target %s at (%s, %s)"
                  .formatted(
                      camera, view, target, world.targets().x(target), world.targets().y(target)));
        }
      }
    }
  }

  private static void assertLooksAsItDetects(World world, Sight sight) {
    sight.locate();
    int targets = world.targets().count();
    for (int camera = 0; camera < world.cameras().count(); camera++) {
      int views = world.cameras().views(camera);
      long[] masks = new long[views];
      sight.detections(camera, masks, 1);
      for (int view = 0; view < views; view++) {
        world.cameras().turnTo(camera, view);
        int[] counts = new int[targets];
        int detected = sight.look(camera, counts, new long[targets + 1]);
        for (int target = 0; target < targets; target++) {
          int expected = sight.detects(camera, view, target) ? 1 : 0;
          assertEquals(expected, counts[target]);
          assertEquals(expected, masks[view] >>> target & 1);
        }
        assertEquals(Arrays.stream(counts).sum(), detected);
      }
    }
  }

  @Property(tries = 50, edgeCases = EdgeCasesMode.NONE)
  void dominatingLevelDetectsAllOfTheOther(
      @ForAll @IntRange(max = 4) int modelNumber, @ForAll long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    World world = randomWorld(random);
    Detection detection = new Detection(model(modelNumber, random), random.nextDouble(0.05, 0.7));
    Sight sight = new Sight(world, Visibility.of(detection));
    for (int camera = 0; camera < CAMERAS; camera++) {
      for (int view = 0; view < 3; view++) {
        assertTrue(sight.dominates(camera, view, view));
        for (int other = 0; other < 3; other++) {
          for (int target = 0; target < TARGETS && sight.dominates(camera, view, other); target++) {
            assertTrue(
                !sight.detects(camera, other, target) || sight.detects(camera, view, target));
          }
        }
      }
    }
  }

  @Test
  void widerLevelsDominateWithoutChance() {
    World world = randomWorld(new SplittableRandom(1));
    Sight sight = new Sight(world, Visibility.of(Detection.of(new GeometricDetection())));
    assertTrue(sight.dominates(0, 2, 0));
    assertTrue(sight.dominates(0, 2, 1));
    assertFalse(sight.dominates(0, 0, 1));
  }

  @Test
  void bearingModelDominatesOnlyTheSameLevel() {
    World world = randomWorld(new SplittableRandom(1));
    Sight sight = new Sight(world, Visibility.of(Detection.of(new CamSimVisibilityDetection())));
    assertTrue(sight.dominates(0, 1, 1));
    assertFalse(sight.dominates(0, 2, 0));
  }

  private static DetectionModel model(int modelNumber, SplittableRandom random) {
    return switch (modelNumber) {
      case 0 -> new CamSimRangeDetection();
      case 1 -> new CamSimStandardDetection();
      case 2 -> new GeometricDetection();
      default -> new Rings(random.nextDouble(15), random.nextDouble(6.3));
    };
  }

  private static World randomWorld(SplittableRandom random) {
    return randomWorld(random, 0.1, 0.66, 1.3);
  }

  /**
   * Returns a world of cameras with sectors or circles, and targets of these sizes, some of them
   * exactly at cameras.
   */
  private static World randomWorld(SplittableRandom random, double... sizes) {
    TestScenario scenario = new TestScenario().zooms(1 + random.nextDouble(), 4, 7.5);
    for (int camera = 0; camera < CAMERAS; camera++) {
      double angle = random.nextInt(3) == 0 ? 360 : random.nextDouble(1, 360);
      scenario.camera(
          TestScenario.camera(
              "c" + camera,
              random.nextInt(-8, 9),
              random.nextInt(-8, 9),
              random.nextDouble(360),
              angle,
              5));
    }
    for (int target = 0; target < TARGETS; target++) {
      boolean onGrid = random.nextInt(4) == 0;
      double x = onGrid ? random.nextInt(-8, 9) : random.nextDouble(-10, 10);
      double y = onGrid ? random.nextInt(-8, 9) : random.nextDouble(-10, 10);
      scenario.target(
          TestScenario.target(target, x, y, 0, 0).withSize(sizes[random.nextInt(sizes.length)]));
    }
    return scenario.world();
  }
}
