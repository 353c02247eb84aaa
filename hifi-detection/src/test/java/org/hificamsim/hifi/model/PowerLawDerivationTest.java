package org.hificamsim.hifi.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.apache.commons.math3.stat.regression.OLSMultipleLinearRegression;
import org.hificamsim.hifi.feature.LinearAbstraction;
import org.hificamsim.hifi.feature.PowerLawAbstraction;
import org.junit.jupiter.api.Test;

/**
 * Tests that the catalogue's power law follows from Eq 4.4, by least squares on the grid of the
 * lab.
 */
class PowerLawDerivationTest {
  private static final double[] FOCAL_LENGTHS = {0.010, 0.015, 0.024, 0.050, 0.070, 0.085};
  private static final double[] SIZES = {0.10, 0.12, 0.16, 0.22, 0.30, 0.40, 0.52, 0.66};
  private static final double SENSOR_HEIGHT = 0.015;
  private static final LinearAbstraction LIN = new LinearAbstraction(-18.82, -2.0, 0.2, 2.47);

  private final List<double[]> logarithms = new ArrayList<>();
  private final List<Double> responses = new ArrayList<>();

  @Test
  void shippedCoefficientsAreTheLeastSquaresSolution() {
    fillGrid();
    assertEquals(458, responses.size());
    OLSMultipleLinearRegression regression = new OLSMultipleLinearRegression();
    regression.newSampleData(
        responses.stream().mapToDouble(Double::doubleValue).toArray(),
        logarithms.toArray(double[][]::new));
    double[] solved = regression.estimateRegressionParameters();
    PowerLawAbstraction shipped = (PowerLawAbstraction) Features.abstraction("power");
    String derived =
        "c %s a %s b %s e %s".formatted(Math.pow(10, solved[0]), solved[1], solved[2], -solved[3]);
    assertEquals(Math.pow(10, solved[0]), shipped.c(), 1e-9, derived);
    assertEquals(solved[1], shipped.a(), 1e-9, derived);
    assertEquals(solved[2], shipped.b(), 1e-9, derived);
    assertEquals(-solved[3], shipped.e(), 1e-9, derived);
    assertEquals(
        String.format(
            Locale.ROOT, "R2 %.3f with Eq 4.4 at these points", regression.calculateRSquared()),
        Features.feature("power").provenance().remarks().get("agreement"));
  }

  private void fillGrid() {
    for (double z : FOCAL_LENGTHS) {
      for (double q : SIZES) {
        for (int d = 1; d <= 10; d++) {
          if (z * q / d <= SENSOR_HEIGHT) {
            logarithms.add(new double[] {Math.log10(z), Math.log10(q), Math.log10(d)});
            responses.add(-LIN.negativeLogPip(q, d, z));
          }
        }
      }
    }
  }
}
