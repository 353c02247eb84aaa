package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;

/**
 * Tests when a grid exists, from 4,000 pairs and 40 cells on, and that its cells are as wide as the
 * mean reach.
 */
class SightGridTest {
  private static final int TARGETS = 50;

  /** Detects targets that the lens shows large enough. */
  private record Lens() implements DetectionModel {
    @Override
    public String name() {
      return "lens";
    }

    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return distance * zoom.viewingAngle() <= 4 ? 1 : 0;
    }
  }

  @Test
  void cellSideIsTheMeanReach() {
    assertEquals(64, cells(cameras(80, 40, 40), new GeometricDetection()));
  }

  @Test
  void hasOneCellForFewPairs() {
    assertEquals(1, cells(cameras(79, 40, 40), new GeometricDetection()));
  }

  @Test
  void hasOneCellForSmallField() {
    assertEquals(40, cells(cameras(80, 40, 25), new GeometricDetection()));
    assertEquals(1, cells(cameras(80, 35, 25), new GeometricDetection()));
  }

  /** The reach is 7.6 m at 30 degrees and 3.8 m at 60; the side is 5.4 m. */
  @Test
  void cellSideAveragesReachesOfLens() {
    OpticsSpec optics = new OpticsSpec("lens").with(OpticsSpec.ANGLES_OF_VIEW, List.of(30.0, 60.0));
    TestScenario scenario = new TestScenario().field(0, 40, 0, 40);
    for (int camera = 0; camera < 80; camera++) {
      scenario.camera(TestScenario.camera("c" + camera, 1, 1, 0, optics));
    }
    assertEquals(64, cells(withTargets(scenario), new Lens()));
  }

  private static int cells(TestScenario scenario, DetectionModel model) {
    World world = scenario.world();
    return new TestNetwork(world, Visibility.of(Detection.of(model))).grid().cells();
  }

  /** Returns a scenario in which every other camera detects up to 4 m, and the others up to 6 m. */
  private static TestScenario cameras(int cameras, double width, double height) {
    TestScenario scenario = new TestScenario().field(0, width, 0, height);
    for (int camera = 0; camera < cameras; camera++) {
      double range = camera % 2 == 0 ? 4 : 6;
      scenario.camera(TestScenario.camera("c" + camera, 1, 1, 0, 360, range));
    }
    return withTargets(scenario);
  }

  private static TestScenario withTargets(TestScenario scenario) {
    for (int target = 0; target < TARGETS; target++) {
      scenario.target(2, 2);
    }
    return scenario;
  }
}
