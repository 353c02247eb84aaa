package org.hificamsim.core.world.movement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.core.TestScenario;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class WaypointsMovementTest {
  @Test
  void goesToSecondWaypointAndBack() {
    World world = walker(1, 0, 0, 5, 0);
    assertPath(world, 1, 2, 3, 4, 5, 4, 3, 2, 1, 0, 1);
  }

  @Test
  void returnsFromLastWaypointToFirst() {
    World world = walker(1, 0, 0, 4, 0, 4, 4);
    for (int i = 0; i < 9; i++) {
      world.moveTargets();
    }
    double diagonal = Math.sqrt(0.5);
    assertEquals(4 - diagonal, world.targets().x(0), 1e-12);
    assertEquals(4 - diagonal, world.targets().y(0), 1e-12);
  }

  @Test
  void overshootsWaypointsWithFullSteps() {
    World world = walker(3, 0, 0, 5, 0);
    assertPath(world, 3, 6, 3, 6, 3, 6);
  }

  @Test
  void turnsOnlyWithinTheThreshold() {
    double near = 1 - 0.00001;
    World at = walker(0.5, near, 0, 0, 0, near, 9);
    at.moveTargets();
    assertEquals(near - 0.5, at.targets().x(0), 1e-12, "at the threshold: towards the second");
    World within = walker(0.5, Math.nextDown(near), 0, 0, 0, Math.nextDown(near), 9);
    within.moveTargets();
    assertEquals(0.5, within.targets().y(0), 1e-12, "within: towards the third");
  }

  @Test
  void turnsAtMostOncePerStep() {
    World world = walker(0.5, 0, 0, 0, 0, 0, 0, 0, 9);
    world.moveTargets();
    assertEquals(0.5, world.targets().x(0), 1e-12, "the third waypoint, where it stands: due east");
    world.moveTargets();
    assertTrue(world.targets().y(0) > 0.4, "the fourth waypoint");
  }

  @Test
  void computesHeadingAsCamSimDoes() {
    World world = walker(0.5, 1, 2, -3, 7);
    world.moveTargets();
    double heading = Math.atan2(1, 0) - Math.atan2(7 - 2, -3 - 1);
    assertEquals(heading, world.targets().heading(0));
    assertEquals(1 + Math.sin(heading) * 0.5, world.targets().x(0));
    assertEquals(2 + Math.cos(heading) * 0.5, world.targets().y(0));
  }

  @Test
  void staysInPlaceIfNextStepLeavesField() {
    World world = walker(3, 0, 0, 9, 0);
    assertPath(world, 3, 6, 9, 6);
    World stuck = walker(3, 8, 0, 9.5, 0);
    assertPath(stuck, 8, 8, 8);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.1, 0.7, 1.3})
  void everyStepHasLengthOfSpeed(double speed) {
    World world = walker(speed, -8, -8, 8, -8, 8, 8, -8, 8);
    double x = world.targets().x(0);
    double y = world.targets().y(0);
    for (int i = 0; i < 1000; i++) {
      world.moveTargets();
      assertEquals(speed, Math.hypot(world.targets().x(0) - x, world.targets().y(0) - y), 1e-12);
      x = world.targets().x(0);
      y = world.targets().y(0);
    }
  }

  @ParameterizedTest
  @CsvSource({"'', 2, 3", "Waypoints, 7, 8", "Straight, 7, 8"})
  void startsOnFirstWaypointIfMovementIsUnnamed(String movement, double x, double y) {
    TargetSpec walker =
        TestScenario.walker(1, movement, 1, 2, 3, 4, 5).with(TargetSpec.X, 7).with(TargetSpec.Y, 8);
    World world = new TestScenario().target(walker).world();
    assertEquals(x, world.targets().x(0));
    assertEquals(y, world.targets().y(0));
  }

  private static void assertPath(World world, double... x) {
    for (double expected : x) {
      world.moveTargets();
      assertEquals(expected, world.targets().x(0), 1e-9);
      assertEquals(0, world.targets().y(0), 1e-9);
    }
  }

  private static World walker(double speed, double... corners) {
    return new TestScenario().target(TestScenario.walker(1, "Waypoints", speed, corners)).world();
  }
}
