package org.hificamsim.core.detection;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Compares the computed probabilities with published tables and with the integrated density. */
class NormalDistributionTest {
  @ParameterizedTest
  @CsvSource({
    "0, 0.5",
    "1, 0.8413447460685429",
    "-1, 0.15865525393145705",
    "1.96, 0.9750021048517795",
    "-3, 0.0013498980316300946",
    "0.03, 0.5119664734141126",
    "5, 0.9999997133484281",
    "9, 1",
    "-9, 0",
  })
  void matchesPublishedValues(double x, double expected) {
    assertEquals(expected, NormalDistribution.cdf(x), 2e-15);
  }

  @Test
  void slopeEqualsTheDensity() {
    double h = 1e-4;
    for (double x = -7.99; x < 7.98; x += 0.0137) {
      double middle = x + h / 2;
      double density = Math.exp(-middle * middle / 2) / Math.sqrt(2 * Math.PI);
      double rise = NormalDistribution.cdf(x + h) - NormalDistribution.cdf(x);
      assertEquals(density, rise / h, 1e-8, "at " + x);
    }
  }

  @Test
  void handlesNaNAndInfinity() {
    assertTrue(Double.isNaN(NormalDistribution.cdf(Double.NaN)));
    assertEquals(1, NormalDistribution.cdf(Double.POSITIVE_INFINITY));
    assertEquals(0, NormalDistribution.cdf(Double.NEGATIVE_INFINITY));
  }

  @ParameterizedTest
  @CsvSource({
    "0.95, 1.6448536269514722",
    "0.99, 2.3263478740408408",
    "0.5, 0",
    "0.001, -3.0902323"
  })
  void quantileIsTheInverse(double chance, double expected) {
    assertEquals(expected, NormalDistribution.quantile(chance), 1e-7);
    assertEquals(chance, NormalDistribution.cdf(NormalDistribution.quantile(chance)), 1e-15);
  }
}
