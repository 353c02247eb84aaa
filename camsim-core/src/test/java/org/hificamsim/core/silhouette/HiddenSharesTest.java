package org.hificamsim.core.silhouette;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Extent;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.movement.Movements;
import org.junit.jupiter.api.Test;

/** Compares hidden shares in random scenes with rays that are cast at each target's rectangle. */
class HiddenSharesTest {
  private final Random random = new Random(56);

  /** The number of walls in addition to those of every scene. */
  private int walls;

  private int scenes = 30;
  private int raster = 150;

  private double randomBetween(double from, double to) {
    return from + random.nextDouble() * (to - from);
  }

  @Test
  void flatWorldAgreesWithRays() {
    agreesWithRays(Double.NaN);
  }

  @Test
  void worldWithHeightsAgreesWithRays() {
    agreesWithRays(4);
  }

  @Test
  void manyFullAndLowWallsAgreeWithRays() {
    walls = 25;
    scenes = 6;
    raster = 60;
    agreesWithRays(4);
    agreesWithRays(Double.NaN);
  }

  private void agreesWithRays(double z) {
    int partly = 0;
    for (int scene = 0; scene < scenes; scene++) {
      World world = world(z);
      HiddenShares shares = new HiddenShares(world);
      shares.begin();
      for (int target = 0; target < world.targets().count(); target++) {
        if (standsInObstacle(world, target)) {
          continue; // the simulator's people do not
        }
        double share = shares.share(0, target);
        assertEquals(
            rays(world, target, z), share, 3.0 / raster, "scene " + scene + " target " + target);
        partly += share > 0.02 && share < 0.98 ? 1 : 0;
      }
    }
    assertTrue(partly > 3 * scenes, "partly hidden: " + partly);
  }

  private World world(double z) {
    CameraSpec camera = new CameraSpec("c", 0, 0, 50);
    List<TargetSpec> targets = new ArrayList<>();
    for (int i = 0; i < 40; i++) {
      double angle = randomBetween(-Math.PI, Math.PI);
      double distance = randomBetween(0.7, 15);
      targets.add(
          new TargetSpec(i, distance * Math.cos(angle), distance * Math.sin(angle))
              .withExtent(new Extent(randomBetween(0.3, 1.2), randomBetween(1, 2))));
    }
    Scenario scenario =
        scenario(Double.isNaN(z) ? camera : camera.with(CameraSpec.Z, z), targets)
            .with(Scenario.OBSTACLES, obstacles(Double.isNaN(z)));
    return new World(scenario, Movements.registry(), 0);
  }

  private static Scenario scenario(CameraSpec camera, List<TargetSpec> targets) {
    return new Scenario("s", new Field(-50, 50, -50, 50))
        .with(Scenario.CAMERAS, List.of(camera))
        .with(Scenario.TARGETS, targets);
  }

  private List<Obstacle> obstacles(boolean flat) {
    double top = flat ? Double.POSITIVE_INFINITY : randomBetween(0.5, 3);
    double x = randomBetween(3, 8);
    double y = randomBetween(-8, 8);
    List<Point> points = List.of(new Point(x, y), new Point(x + 1, y), new Point(x, y + 2));
    List<Obstacle> obstacles = new ArrayList<>();
    for (int i = 0; i < walls; i++) {
      double fromX = randomBetween(-15, 15);
      double fromY = randomBetween(-15, 15);
      double height = flat || i % 3 == 0 ? Double.POSITIVE_INFINITY : randomBetween(0.3, 5);
      double base = flat || i % 5 != 0 ? 0 : randomBetween(0, 0.3);
      obstacles.add(
          new Obstacle.Wall(
              fromX,
              fromY,
              fromX + randomBetween(-4, 4),
              fromY + randomBetween(-4, 4),
              0,
              base,
              base + height));
    }
    Collections.addAll(
        obstacles,
        new Obstacle.Wall(-9, randomBetween(-9, 9), -3, randomBetween(-9, 9), 0, 0, top),
        new Obstacle.Wall(-2, 5, 2, randomBetween(4, 7), 0, 0, Double.POSITIVE_INFINITY),
        new Obstacle.Wall(-2, -5, 2, -6, 0.5, 0, Double.POSITIVE_INFINITY),
        new Obstacle.Polygon(points, 0, 0, top),
        new Obstacle.Pillar(5, 0, 0.4, 0, 0, Double.POSITIVE_INFINITY));
    return obstacles;
  }

  /** Casts rays at the points of the target's rectangle, which faces the camera. */
  private double rays(World world, int target, double z) {
    double x = world.targets().x(target);
    double y = world.targets().y(target);
    double distance = Math.hypot(x, y);
    int hidden = 0;
    int rows = Double.isNaN(z) ? 1 : raster;
    for (int i = 0; i < raster * rows; i++) {
      double aside = ((i % raster + 0.5) / raster - 0.5) * world.targets().width(target);
      double up = (i / raster + 0.5) / raster * world.targets().height(target);
      double[] end = {x + aside * y / distance, y - aside * x / distance, up};
      hidden += isHidden(world, target, end, z) ? 1 : 0;
    }
    return hidden / (double) (raster * rows);
  }

  private static boolean standsInObstacle(World world, int target) {
    double x = world.targets().x(target);
    double y = world.targets().y(target);
    double half = world.targets().width(target) / 2 / Math.hypot(x, y);
    return world.scenario().obstacles().stream()
        .anyMatch(
            obstacle -> obstacle.touches(x + half * y, y - half * x, x - half * y, y + half * x));
  }

  private static boolean isHidden(World world, int target, double[] end, double z) {
    double x = world.targets().x(target);
    double y = world.targets().y(target);
    double distance = Math.hypot(x, y);
    for (int other = 0; other < world.targets().count(); other++) {
      double otherX = world.targets().x(other);
      double otherY = world.targets().y(other);
      // the plane of the other target's rectangle is parallel to that of the target's
      double part = (otherX * x + otherY * y) / (distance * distance);
      double across = ((otherX - part * end[0]) * y - (otherY - part * end[1]) * x) / distance;
      double height = z + part * (end[2] - z);
      if (Math.hypot(otherX, otherY) < distance
          && part > 0
          && Math.abs(across) < world.targets().width(other) / 2
          && (Double.isNaN(z) || height < world.targets().height(other))) {
        return true;
      }
    }
    return world.scenario().obstacles().stream()
        .filter(Obstacle::solid)
        .anyMatch(obstacle -> obstacle.touches(0, 0, z, end[0], end[1], end[2], end[2]));
  }

  @Test
  void nearerTargetHidesHalfOfOneBehind() {
    TargetSpec near = new TargetSpec(1, 0.25, 5).withExtent(new Extent(0.5, 1.75));
    TargetSpec far = new TargetSpec(2, 0, 10).withExtent(new Extent(1, 1.75));
    Scenario scenario = scenario(new CameraSpec("c", 0, 0, 50), List.of(near, far));
    HiddenShares shares = new HiddenShares(new World(scenario, Movements.registry(), 0));
    assertEquals(0, shares.share(0, 0));
    assertEquals(0.5, shares.share(0, 1), 1e-12);
  }

  @Test
  void movedTargetIsComputedAgainAfterBegin() {
    TargetSpec near = new TargetSpec(1, 0, 5);
    TargetSpec far = new TargetSpec(2, 0, 10);
    Scenario scenario = scenario(new CameraSpec("c", 0, 0, 50), List.of(near, far));
    World world = new World(scenario, Movements.registry(), 0);
    HiddenShares shares = new HiddenShares(world);
    assertEquals(1, shares.share(0, 1), 1e-12);
    world.targets().put(0, 5, 5);
    shares.begin();
    assertEquals(0, shares.share(0, 1));
  }
}
