package org.hificamsim.core.world.movement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;

class RandomWaypointMovementTest {
  @Test
  void walksAtItsSpeedAllOverTheField() {
    World world = world(List.of(), 3);
    Targets targets = world.targets();
    int quadrants = 0;
    for (int step = 0; step < 2_000; step++) {
      double x = targets.x(0);
      double y = targets.y(0);
      world.moveTargets();
      double way = Math.hypot(targets.x(0) - x, targets.y(0) - y);
      assertTrue(way <= 0.5 + 1e-9, "a step of " + way);
      assertTrue(Math.abs(targets.x(0)) <= 10 && Math.abs(targets.y(0)) <= 10);
      quadrants |= 1 << ((targets.x(0) > 0 ? 1 : 0) + (targets.y(0) > 0 ? 2 : 0));
    }
    assertEquals(15, quadrants);
  }

  @Test
  void walksAroundWalls() {
    List<Obstacle> walls = List.of(new Obstacle.Wall(0, -8, 0, 8, 0));
    Obstacles obstacles = new Obstacles(walls);
    World world = world(walls, 5);
    int crossings = 0;
    for (int step = 0; step < 3_000; step++) {
      double x = world.targets().x(0);
      double y = world.targets().y(0);
      world.moveTargets();
      assertTrue(obstacles.clear(x, y, world.targets().x(0), world.targets().y(0)));
      crossings += x > 0 == world.targets().x(0) > 0 ? 0 : 1;
    }
    assertTrue(crossings > 2, "crossed " + crossings + " times");
  }

  @Test
  void staysInsideClosedWalls() {
    List<Obstacle> cell =
        List.of(
            new Obstacle.Wall(2, 2, 4, 2, 0),
            new Obstacle.Wall(4, 2, 4, 4, 0),
            new Obstacle.Wall(4, 4, 2, 4, 0),
            new Obstacle.Wall(2, 4, 2, 2, 0));
    World world = world(cell, 7);
    for (int step = 0; step < 1_000; step++) {
      world.moveTargets();
      assertTrue(world.targets().x(0) > 2 && world.targets().x(0) < 4);
      assertTrue(world.targets().y(0) > 2 && world.targets().y(0) < 4);
    }
  }

  @Test
  void straightMovementTurnsAtWall() {
    World world =
        new TestScenario()
            .camera(0, 0)
            .target(-3, 0, 90, 0.5)
            .obstacles(new Obstacle.Wall(0, -10, 0, 10, 0))
            .world(1);
    for (int step = 0; step < 500; step++) {
      world.moveTargets();
      assertTrue(world.targets().x(0) < 0);
    }
  }

  private static World world(List<Obstacle> obstacles, long seed) {
    return new TestScenario()
        .camera(0.1, 9)
        .target(TestScenario.target(0, 3, 3, 0, 0.5).withMovement("RandomWaypoint"))
        .with(Scenario.OBSTACLES, obstacles)
        .world(seed);
  }
}
