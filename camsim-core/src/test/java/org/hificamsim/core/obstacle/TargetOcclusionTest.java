package org.hificamsim.core.obstacle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.hificamsim.core.AllocatedBytes;
import org.junit.jupiter.api.Test;

class TargetOcclusionTest {
  @Test
  void hidesBehindCrossedOrTouchedDisc() {
    assertTrue(hidden(10, 0, 5, 0, 1));
    assertTrue(hidden(10, 0, 5, 1, 1), "touched at its border");
    assertFalse(hidden(10, 0, 5, Math.nextUp(1.0), 1), "just beside");
  }

  @Test
  void discsBehindTargetOrCameraHideNothing() {
    assertFalse(hidden(10, 0, 12, 0, 1));
    assertFalse(hidden(10, 0, -5, 0, 1));
  }

  @Test
  void targetDoesNotHideItself() {
    assertFalse(TargetOcclusion.hidden(0, 0, 0, array(10), array(0), array(20), 1));
  }

  @Test
  void discAroundCameraHidesNothing() {
    assertFalse(hidden(10, 0, 1, 0, 2));
    assertFalse(hidden(10, 0, 1, 0, 1), "on its border");
    assertTrue(hidden(10, 0, 1, 0, Math.nextDown(1.0)));
  }

  @Test
  void nearerOfOverlappingDiscsHidesTheOther() {
    assertTrue(hidden(10, 0, 9.5, 0, 1));
    assertFalse(hidden(9.5, 0, 10, 0, 1));
    assertFalse(hidden(10, 0, 10, 0, 1), "at the same place");
    assertFalse(hidden(10, 0, 0, 10, 20), "equally far");
  }

  @Test
  void pointsAndUncountedDiscsHideNothing() {
    double[] x = {10, 5};
    double[] y = {0, 0};
    assertFalse(TargetOcclusion.hidden(0, 0, 0, x, y, array(1, 1), 1));
    assertFalse(TargetOcclusion.hidden(0, 0, 0, x, y, array(1, 0), 2));
  }

  @Property(tries = 5000, edgeCases = EdgeCasesMode.NONE)
  void agreesWithExactArithmetic(@ForAll long seed) {
    RandomPlace place = new RandomPlace(seed);
    Point camera = place.point();
    Point target = place.point();
    Obstacle.Pillar disc = place.pillar(true);
    double[] x = {target.x(), disc.x()};
    double[] y = {target.y(), disc.y()};
    boolean nearer = square(camera, x[1], y[1]) < square(camera, x[0], y[0]);
    boolean expected =
        nearer && Exact.touches(disc, camera, target) && !Exact.touches(disc, camera, camera);
    assertEquals(
        expected,
        TargetOcclusion.hidden(camera.x(), camera.y(), 0, x, y, array(1, disc.radius()), 2),
        () -> "from " + camera + " to " + target + " past " + disc);
  }

  private static double square(Point from, double x, double y) {
    double dx = x - from.x();
    double dy = y - from.y();
    return dx * dx + dy * dy;
  }

  @Test
  void hiddenAllocatesNothing() {
    double[] x = {10, 5, 7, 3, 9};
    double[] y = {0, 0.3, -4, 2, 1};
    double[] radius = {1, 0.2, 3, 0.7, 0.1};
    int[] hidden = new int[1];
    Runnable queries =
        () -> {
          for (int i = 0; i < 10_000; i++) {
            boolean hides = TargetOcclusion.hidden(0.3, i / 1e4, i % 5, x, y, radius, 5);
            hidden[0] += hides ? 1 : 0;
          }
        };
    assertEquals(0, AllocatedBytes.fewest(() -> AllocatedBytes.by(queries)));
    assertTrue(hidden[0] > 0);
  }

  private static boolean hidden(double x, double y, double discX, double discY, double radius) {
    double[] radii = {1, radius};
    return TargetOcclusion.hidden(0, 0, 0, array(x, discX), array(y, discY), radii, 2);
  }

  private static double[] array(double... values) {
    return values;
  }
}
