package org.hificamsim.core.obstacle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.hificamsim.core.AllocatedBytes;
import org.junit.jupiter.api.Test;

class VisibleRegionTest {
  @Property(tries = 5000, edgeCases = EdgeCasesMode.NONE)
  void agreesWithObstacles(@ForAll long seed) {
    assertSame(new RandomPlace(seed), seed % 5 == 0 ? 40 : 6);
  }

  @Property(tries = 1000, edgeCases = EdgeCasesMode.NONE)
  void agreesWithObstaclesAtAnyScale(@ForAll long seed) {
    assertSame(RandomPlace.ofAnySize(seed), 10);
  }

  private static void assertSame(RandomPlace place, int most) {
    Obstacles obstacles = place.obstacles(most, false);
    Point standpoint = place.target(obstacles, place.point());
    VisibleRegion region = VisibleRegion.of(obstacles, standpoint.x(), standpoint.y());
    for (int i = 0; i < 100; i++) {
      assertSame(obstacles, region, standpoint, place.target(obstacles, standpoint));
    }
    assertSame(obstacles, region, standpoint, standpoint);
  }

  private static void assertSame(
      Obstacles obstacles, VisibleRegion region, Point standpoint, Point target) {
    assertEquals(
        obstacles.transmittance(standpoint.x(), standpoint.y(), target.x(), target.y()),
        region.transmittance(target.x(), target.y()),
        () -> "from " + standpoint + " to " + target + " past " + obstacles.all());
    assertEquals(
        obstacles.clear(standpoint.x(), standpoint.y(), target.x(), target.y()),
        region.transmittance(target.x(), target.y()) > 0,
        () -> "from " + standpoint + " to " + target + " past " + obstacles.all());
  }

  @Test
  void seesEverythingWithoutObstacles() {
    VisibleRegion region = VisibleRegion.of(Obstacles.NONE, 1, 2);
    assertEquals(1, region.transmittance(1, 2));
    assertEquals(1, region.transmittance(-1e6, 1e6));
    assertEquals(1, region.transmittance(7, 7));
  }

  @Test
  void seesNothingFromSolidBorder() {
    VisibleRegion region = VisibleRegion.of(wall(0, 0, 4, 0, 0), 1, 0);
    assertEquals(0, region.transmittance(1, 0));
    assertEquals(0, region.transmittance(1, 3));
    assertEquals(0, region.transmittance(-9, 0));
  }

  @Test
  void seesDimlyOutOfTranslucentPolygon() {
    List<Point> square =
        List.of(new Point(0, 0), new Point(4, 0), new Point(4, 4), new Point(0, 4));
    Obstacles obstacles = new Obstacles(List.of(new Obstacle.Polygon(square, 0.5)));
    VisibleRegion region = VisibleRegion.of(obstacles, 1, 1);
    assertEquals(0.5, region.transmittance(2, 3));
    assertEquals(0.5, region.transmittance(20, 3));
  }

  @Test
  void seesUpToButNotOntoWall() {
    VisibleRegion region = VisibleRegion.of(wall(5, -5, 5, 5, 0), 0, 0);
    assertEquals(1, region.transmittance(Math.nextDown(5.0), 1));
    assertEquals(0, region.transmittance(5, 1));
    assertEquals(0, region.transmittance(10, 10));
    assertEquals(1, region.transmittance(10, Math.nextUp(10.0)));
  }

  @Test
  void transmittanceAllocatesNothing() {
    SplittableRandom random = new SplittableRandom(1);
    List<Obstacle> walls = new ArrayList<>();
    for (int i = 0; i < 40; i++) {
      double x = random.nextDouble(100);
      double y = random.nextDouble(100);
      walls.add(new Obstacle.Wall(x, y, x + random.nextDouble(10), y + 5, 0.5 * (i % 2)));
    }
    VisibleRegion region = VisibleRegion.of(new Obstacles(walls), 50, 50);
    int[] seen = new int[1];
    Runnable queries =
        () -> {
          for (int i = 0; i < 10_000; i++) {
            seen[0] += region.transmittance(i % 100, i / 100.0) < 1 ? 1 : 0;
          }
        };
    assertEquals(0, AllocatedBytes.fewest(() -> AllocatedBytes.by(queries)));
    assertTrue(seen[0] > 0);
  }

  private static Obstacles wall(double x1, double y1, double x2, double y2, double transmittance) {
    return new Obstacles(List.of(new Obstacle.Wall(x1, y1, x2, y2, transmittance)));
  }
}
