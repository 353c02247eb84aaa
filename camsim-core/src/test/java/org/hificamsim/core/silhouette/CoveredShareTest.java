package org.hificamsim.core.silhouette;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** Compares unions of random shapes with a raster count. */
class CoveredShareTest {
  private static final int RASTER = 400;

  private final Random random = new Random(3);
  private final CoveredShare covered = new CoveredShare();

  private double around() {
    return -0.4 + 1.8 * random.nextDouble();
  }

  @Test
  void unionOfStripsAgreesWithRaster() {
    for (int scene = 0; scene < 300; scene++) {
      boolean sloped = scene % 2 == 0;
      double[][] shapes = new double[random.nextInt(7)][];
      covered.clear();
      for (int i = 0; i < shapes.length; i++) {
        shapes[i] = shape(sloped);
        covered.add(
            shapes[i][0], shapes[i][1], shapes[i][2], shapes[i][3], shapes[i][4], shapes[i][5]);
      }
      assertEquals(raster(shapes), covered.share(), 0.01);
    }
  }

  /** A strip whose lines do not cross in it. */
  private double[] shape(boolean sloped) {
    double left = around();
    double right = left + random.nextDouble();
    double low = around();
    double slope = sloped ? around() : 0;
    double thickness = random.nextDouble();
    double opening = sloped ? random.nextDouble() : 0;
    return new double[] {
      left, right, low, slope, low + thickness - Math.min(0, left) * opening, slope + opening
    };
  }

  private static double raster(double[][] shapes) {
    int hits = 0;
    for (int i = 0; i < RASTER * RASTER; i++) {
      double x = (i % RASTER + 0.5) / RASTER;
      double y = (i / RASTER + 0.5) / RASTER;
      boolean hit = false;
      for (double[] shape : shapes) {
        hit |=
            x > shape[0]
                && x < shape[1]
                && y > shape[2] + shape[3] * x
                && y < shape[4] + shape[5] * x;
      }
      hits += hit ? 1 : 0;
    }
    return hits / (double) (RASTER * RASTER);
  }

  @Test
  void rectanglesAreExact() {
    covered.clear();
    covered.add(-1, 0.25, 0.5, 0.75);
    covered.add(0.25, 0, 0.75, 0.5);
    assertEquals(0.25 + 0.25 - 0.0625, covered.share(), 1e-15);
  }

  @Test
  void reportsWhenNothingIsLeft() {
    covered.clear();
    covered.add(-1, -1, 2, Double.POSITIVE_INFINITY);
    assertTrue(covered.full());
    assertEquals(1, covered.share());
    covered.clear();
    assertEquals(0, covered.share());
  }
}
