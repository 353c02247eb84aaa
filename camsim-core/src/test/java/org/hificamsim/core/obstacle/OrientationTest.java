package org.hificamsim.core.obstacle;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.hificamsim.core.AllocatedBytes;
import org.junit.jupiter.api.Test;

class OrientationTest {
  @Property(tries = 20_000, edgeCases = EdgeCasesMode.NONE)
  void agreesWithExactArithmetic(@ForAll long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    RandomPlace place = new RandomPlace(seed);
    double scale = Math.scalb(1.0, random.nextInt(-300, 300));
    Point a = scaled(place.point(), scale);
    Point b = scaled(place.point(), scale);
    double along = random.nextInt(-4, 5) / 4.0;
    Point near = new Point(a.x() + along * (b.x() - a.x()), a.y() + along * (b.y() - a.y()));
    Point c = new Point(step(near.x(), random), step(near.y(), random));
    int exact = Exact.orientation(a, b, c);
    assertEquals(exact, Integer.signum(orientation(a, b, c)), () -> a + " " + b + " " + c);
    assertEquals(-exact, Integer.signum(orientation(b, a, c)), () -> b + " " + a + " " + c);
  }

  private static Point scaled(Point point, double scale) {
    return new Point(point.x() * scale, point.y() * scale);
  }

  private static double step(double value, SplittableRandom random) {
    return value + random.nextInt(-1, 2) * Math.ulp(value);
  }

  private static int orientation(Point a, Point b, Point c) {
    return Orientation.of(a.x(), a.y(), b.x(), b.y(), c.x(), c.y());
  }

  @Test
  void ignoresSignOfZero() {
    assertEquals(0, Orientation.of(0.0, 1, -0.0, 2, 0.0, 3));
  }

  @Test
  void decidesCollinearLatticePointsWithoutAllocation() {
    int[] sum = new int[1];
    Runnable work =
        () -> {
          for (int i = 0; i < 10_000; i++) {
            sum[0] += Orientation.of(0.5, 0.25, 1.5 + i, 1.25 + i, 3.5, 3.25);
          }
        };
    assertEquals(0, AllocatedBytes.fewest(() -> AllocatedBytes.by(work)));
    assertEquals(0, sum[0]);
  }
}
