package org.hificamsim.tracks.mate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.LongStream;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;

class MateArenaTest {
  private static final Scenario SITE =
      ScenarioReader.read(Path.of("../scenarios/mate-4v8-9.xml"), movement -> true, warning -> {});

  /** The means of MATE's own twelve episodes, with their 95 % intervals. */
  @Test
  void reproducesMatesGreedyEpisodes() {
    List<MateArena> played =
        LongStream.range(0, 40).mapToObj(seed -> MateArena.play(SITE, seed)).toList();
    assertEquals(.61, played.stream().mapToDouble(MateArena::coverage).average().orElse(0), .035);
    assertEquals(
        .373, played.stream().mapToDouble(MateArena::transported).average().orElse(0), .038);
    assertEquals(1250, played.stream().mapToInt(MateArena::steps).average().orElse(0), 125);
  }

  @Test
  void playsSameEpisodeForSameSeed() {
    assertEquals(MateArena.play(SITE, 7), MateArena.play(SITE, 7));
    assertNotEquals(MateArena.play(SITE, 7), MateArena.play(SITE, 8));
  }

  @Test
  void drawsLayoutsWithinMatesBounds() {
    for (long seed = 0; seed < 200; seed++) {
      Scenario layout = new ArenaLayout(SITE, new SplittableRandom(seed)).scenario();
      for (CameraSpec camera : layout.cameras()) {
        assertTrue(isWithin(camera.x(), 500, 800) && isWithin(camera.y(), 500, 800));
      }
      for (int i = 0; i < layout.obstacles().size(); i++) {
        Obstacle.Pillar disc = (Obstacle.Pillar) layout.obstacles().get(i);
        boolean edge = i > 3 && i < 8; // in the file's order
        double farther = Math.max(Math.abs(disc.x()), Math.abs(disc.y()));
        double nearer = Math.min(Math.abs(disc.x()), Math.abs(disc.y()));
        assertTrue(isWithin(disc.radius(), 25, 100));
        assertTrue(
            i == 8
                ? farther <= 200
                : edge
                    ? isWithin(farther, 880, 900) && nearer <= 500
                    : farther <= 800 && nearer >= 200);
      }
      assertEquals(4, layout.targets().stream().filter(target -> target.speed() == 10).count());
      assertTrue(layout.targets().stream().allMatch(MateArenaTest::startsInTheMiddle));
    }
  }

  private static boolean isWithin(double value, double least, double most) {
    return Math.abs(value) >= least && Math.abs(value) <= most;
  }

  private static boolean startsInTheMiddle(TargetSpec target) {
    return Math.max(Math.abs(target.x()), Math.abs(target.y())) <= 200;
  }

  /** Targets pass no discs and keep their speed; all freight reaches its destination. */
  @Test
  void targetsAvoidDiscsUntilAllFreightIsDelivered() {
    ArenaLayout arena = new ArenaLayout(SITE, new SplittableRandom(1));
    Scenario layout = arena.scenario();
    Freight freight = new Freight(arena, new SplittableRandom(2));
    Registry<Movement> movements = new Registry<>("movement");
    movements.register(Freight.Carrier.NAME, "", () -> freight.new Carrier());
    World world = new World(layout, movements, 3);
    int steps = 0;
    while (!freight.isDelivered()) {
      double[] before = positions(world);
      world.moveTargets();
      double[] after = positions(world);
      for (int target = 0; target < world.targets().count(); target++) {
        double x = after[2 * target];
        double y = after[2 * target + 1];
        double distance = Math.hypot(x - before[2 * target], y - before[2 * target + 1]);
        assertTrue(distance <= 2 * world.targets().speed(target), "slides are short");
        assertTrue(layout.field().contains(x, y));
        assertTrue(
            layout.obstacles().stream().allMatch(disc -> ArenaLayout.distance(disc, x, y) > -1e-9)
                && layout.cameras().stream()
                    .allMatch(disc -> Math.hypot(x - disc.x(), y - disc.y()) > 40 - 1e-9));
      }
      steps++;
    }
    assertTrue(steps > 900 && steps < 2000, "steps " + steps);
    assertEquals(1, freight.payShare(), "no target was seen");
  }

  private static double[] positions(World world) {
    double[] positions = new double[2 * world.targets().count()];
    for (int target = 0; target < world.targets().count(); target++) {
      positions[2 * target] = world.targets().x(target);
      positions[2 * target + 1] = world.targets().y(target);
    }
    return positions;
  }
}
