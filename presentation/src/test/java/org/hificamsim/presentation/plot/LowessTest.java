package org.hificamsim.presentation.plot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class LowessTest {
  @Test
  void straightLineStaysSame() {
    Curve smooth = Lowess.smooth(Curve.of(line(10_000)));
    assertEquals(500, smooth.size());
    for (int i = 0; i < smooth.size(); i++) {
      assertEquals(3 + 0.002 * smooth.x()[i], smooth.y()[i], 1e-9);
    }
  }

  @Test
  void removesMostNoise() {
    double[] noisy = line(2000);
    SplittableRandom random = new SplittableRandom(5);
    Arrays.setAll(noisy, i -> noisy[i] + random.nextDouble() - 0.5);
    Curve smooth = Lowess.smooth(Curve.of(noisy));
    for (int i = 0; i < smooth.size(); i++) {
      assertEquals(3 + 0.002 * smooth.x()[i], smooth.y()[i], 0.12);
    }
  }

  @Test
  void shortCurveStaysSame() {
    Curve curve = Curve.of(new double[] {0, 1, 0, 1});
    assertArrayEquals(curve.y(), Lowess.smooth(curve).y());
  }

  @Test
  void thinnedCurveHasMeansOfNeighbours() {
    Curve thin = Curve.of(new double[] {1, 3, 5, 7, 9, 11}).thinned(3);
    assertArrayEquals(new double[] {0.5, 2.5, 4.5}, thin.x());
    assertArrayEquals(new double[] {2, 6, 10}, thin.y());
  }

  @Test
  void thinnedCurveUsesAllPoints() {
    double[] ones = new double[1003];
    Arrays.fill(ones, 1);
    Curve thin = Curve.of(ones).thinned(7);
    assertEquals(7, thin.size());
    assertTrue(Arrays.stream(thin.y()).allMatch(y -> y == 1));
  }

  private static double[] line(int size) {
    double[] values = new double[size];
    Arrays.setAll(values, i -> 3 + 0.002 * i);
    return values;
  }
}
