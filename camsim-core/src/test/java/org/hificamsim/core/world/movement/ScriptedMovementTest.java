package org.hificamsim.core.world.movement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import org.hificamsim.core.TestScenario;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;

class ScriptedMovementTest {
  @Test
  void startsOnFirstWaypoint() {
    TargetSpec walker =
        TestScenario.walker(1, "Scripted", 1, 3, 4, 5, 6)
            .with(TargetSpec.X, -7)
            .with(TargetSpec.Y, -7);
    World world = new TestScenario().target(walker).world();
    assertEquals(3, world.targets().x(0));
    assertEquals(4, world.targets().y(0));
  }

  @Test
  void landsOnEachCornerAndRepeats() {
    World world = walk(3, 0, 0.1, 0.2, 5.7, 0.2, 5.7, 3.3);
    double[][] firstRound = {{0.1 + 3, 0.2}, {5.7, 0.2}, {5.7, 3.2}, {5.7, 3.3}};
    for (double[] corner : firstRound) {
      world.moveTargets();
      assertEquals(corner[0], world.targets().x(0), 1e-15);
      assertEquals(corner[1], world.targets().y(0), 1e-15);
    }
    world.moveTargets();
    world.moveTargets();
    assertNotEquals(0.1, world.targets().x(0));
    world.moveTargets();
    assertEquals(0.1, world.targets().x(0), "back on the first corner, to the last bit");
    assertEquals(0.2, world.targets().y(0));
    world.moveTargets();
    assertEquals(0.2, world.targets().y(0), "and towards the second again");
  }

  @Test
  void reachesWaypointAtExactlyItsSpeed() {
    World world = walk(2, 1, 0, 0, 2, 0, 2, 1);
    assertEquals(2, world.targets().x(0));
    world.moveTargets();
    assertEquals(1, world.targets().y(0), "and the next one is aimed at");
  }

  @Test
  void stopsAtWaypointJustBeyondItsSpeed() {
    double far = Math.nextUp(2.0);
    World world = walk(2, 1, 0, 0, far, 0, far, 1);
    world.moveTargets();
    assertEquals(far, world.targets().x(0));
    assertEquals(0, world.targets().y(0));
  }

  @Test
  void restsOneStepAtRepeatedWaypoint() {
    World world = walk(2, 1, 0, 0, 2, 0, 2, 0, 4, 0);
    world.moveTargets();
    assertEquals(2, world.targets().x(0));
    world.moveTargets();
    assertEquals(4, world.targets().x(0));
  }

  @Test
  void ignoresSignOfSpeed() {
    World world = walk(-2, 1, 0, 0, 3, 0);
    assertEquals(2, world.targets().x(0));
    world.moveTargets();
    assertEquals(3, world.targets().x(0));
  }

  @Test
  void coverageDialectMapsWaypointsToScripted() {
    World world =
        new TestScenario()
            .zooms(1, 2)
            .target(TestScenario.walker(1, "epics.movement.Waypoints", 2, 0, 0, 3, 0))
            .world();
    world.moveTargets();
    world.moveTargets();
    assertEquals(3, world.targets().x(0), "lands where CamSim's own would overshoot");
  }

  private static World walk(double speed, int steps, double... corners) {
    World world =
        new TestScenario().target(TestScenario.walker(1, "Scripted", speed, corners)).world();
    for (int i = 0; i < steps; i++) {
      world.moveTargets();
    }
    return world;
  }
}
