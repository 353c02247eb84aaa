package org.hificamsim.core.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.core.TestScenario;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Occlusion;
import org.hificamsim.core.scenario.spec.ScenarioEvent.ChangeCamera;
import org.junit.jupiter.api.Test;

class SightLinesTest {
  private static final Obstacle WALL = new Obstacle.Wall(-1, 3, 1, 3, 0);

  @Test
  void openFieldHidesNothing() {
    SightLines lines = world(Occlusion.NONE).sightLines();
    assertTrue(lines.open());
    assertFalse(lines.partial());
    assertEquals(1, lines.transmittance(0, 1));
  }

  @Test
  void obstaclesHideOrDimTargets() {
    SightLines solid = world(Occlusion.NONE, WALL).sightLines();
    assertFalse(solid.open());
    assertFalse(solid.partial());
    assertEquals(1, solid.transmittance(0, 0));
    assertEquals(0, solid.transmittance(0, 1));
    SightLines dim =
        world(
                Occlusion.NONE,
                new Obstacle.Wall(-1, 3, 1, 3, 0.25),
                new Obstacle.Wall(7, 7, 8, 8, 0))
            .sightLines();
    assertTrue(dim.partial());
    assertEquals(0.25, dim.transmittance(0, 1));
  }

  /** Targets are 0.66 m wide; one at 2 m hides the one behind it at 5 m. */
  @Test
  void targetsHideTargetsIfOcclusionIsOn() {
    SightLines lines = world(Occlusion.TARGETS).sightLines();
    assertFalse(lines.open());
    assertEquals(1, lines.transmittance(0, 0), "the nearer one is seen");
    assertEquals(0, lines.transmittance(0, 1), "the one behind it is not");
    assertEquals(1, lines.transmittance(1, 1), "but from elsewhere");
  }

  @Test
  void movedCameraSeesFromNewPosition() {
    World world = world(Occlusion.NONE, WALL);
    for (double[] position : new double[][] {{9, 0}, {0, 0}, {0, 4}, {0, 0}}) {
      world.moveCamera(0, position[0], position[1]);
      boolean hidden = position[0] == 0 && position[1] == 0;
      assertEquals(hidden ? 0 : 1, world.sightLines().transmittance(0, 1));
    }
    world.fireEvents(1);
    assertEquals(1, world.sightLines().transmittance(0, 1), "an event moved it");
    world.restart(1);
    assertEquals(0, world.sightLines().transmittance(0, 1), "and it is back");
  }

  private static World world(Occlusion occlusion, Obstacle... obstacles) {
    return new TestScenario()
        .camera(0, 0)
        .camera(5, 5)
        .target(0, 2)
        .target(0, 5)
        .events(new ChangeCamera(1, "c0", 4, 4, -1, -1, -1))
        .obstacles(obstacles)
        .with(Scenario.OCCLUSION, occlusion)
        .world();
  }
}
