package org.hificamsim.core.world.movement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.Random;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;

class StraightMovementTest {
  private static final double FIRST = turn(0.730967787376657);
  private static final double SECOND = turn(0.24053641567148587);

  @Test
  void goesAlongTheHeadingBySpeed() {
    World world = new TestScenario().target(1, 2, 30, 0.5).world();
    world.moveTargets();
    assertEquals(1 + Math.sin(Math.toRadians(30)) * 0.5, world.targets().x(0));
    assertEquals(2 + Math.cos(Math.toRadians(30)) * 0.5, world.targets().y(0));
  }

  @Test
  void headingZeroIsNorthAndNinetyIsEast() {
    World world = new TestScenario().target(0, 0, 0, 1).target(0, 0, 90, 1).world();
    world.moveTargets();
    assertEquals(1, world.targets().y(0));
    assertEquals(0, world.targets().x(0));
    assertEquals(1, world.targets().x(1));
    assertEquals(0, world.targets().y(1), 1e-15);
  }

  @Test
  void borderIsInside() {
    World world = new TestScenario().target(9, 0, 90, 1).target(0, -9, 180, 1).world();
    world.moveTargets();
    assertEquals(10, world.targets().x(0));
    assertEquals(-10, world.targets().y(1));
    assertEquals(Math.toRadians(90), world.targets().heading(0));
    assertEquals(Math.toRadians(180), world.targets().heading(1));
  }

  @Test
  void turnsAtBorderByPublishedFormula() {
    World world = new TestScenario().target(9.5, 0, 90, 1).world(0);
    Targets targets = world.targets();
    world.moveTargets();
    double heading = Math.toRadians(90) + FIRST;
    assertEquals(9.5, targets.x(0));
    assertEquals(heading, targets.heading(0));
    assertEquals(1.5707963267948966 + 3.38346155493592, targets.heading(0), 1e-13);
    double y = targets.y(0);
    world.moveTargets();
    assertEquals(9.5 + Math.sin(heading), targets.x(0));
    assertEquals(y + Math.cos(heading), targets.y(0));
  }

  @Test
  void undoesMoveBySubtraction() {
    World world = new TestScenario().field(-1, 1, -1, 1).target(0.1, 0, 90, 1.7).world();
    world.moveTargets();
    assertEquals((0.1 + 1.7) - 1.7, world.targets().x(0));
    assertNotEquals(0.1, world.targets().x(0), "the example shows the last bits");
  }

  @Test
  void staysOutsideAndTurnsEachStep() {
    World world = new TestScenario().target(20, 0, 0, 1).target(9.5, 0, 90, 1).world(0);
    Targets targets = world.targets();
    world.moveTargets();
    assertEquals(20, targets.x(0));
    assertEquals(FIRST, targets.heading(0));
    assertEquals(Math.toRadians(90) + SECOND, targets.heading(1), "the next number of the stream");
    Random stream = new Random(0);
    stream.nextDouble();
    stream.nextDouble();
    world.moveTargets();
    assertEquals(FIRST + turn(stream.nextDouble()), targets.heading(0));
    assertEquals(20, targets.x(0), 1e-12);
    assertEquals(0, targets.y(0), 1e-12);
  }

  @Test
  void headingsAreNeverNormalised() {
    World world = new TestScenario().target(20, 20, 720, 1).world(0);
    world.moveTargets();
    world.moveTargets();
    assertEquals(Math.toRadians(720) + FIRST + SECOND, world.targets().heading(0));
  }

  @Test
  void negativeSpeedGoesBackwards() {
    World world = new TestScenario().target(0, 0, 90, -2).world();
    world.moveTargets();
    assertEquals(-2, world.targets().x(0));
  }

  private static double turn(double u) {
    return Math.PI + ((u * 2 - 1) * Math.PI) / 6;
  }
}
