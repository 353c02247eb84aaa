package org.hificamsim.runs.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.runs.Estimate;
import org.junit.jupiter.api.Test;

class RatioTest {
  @Test
  void isRatioOfSumsNotMeanOfRatios() {
    Ratio ratio = new Ratio(new double[] {1, 30}, new double[] {10, 30});
    assertEquals(31.0 / 40, ratio.estimate().mean());
  }

  @Test
  void hasSameIntervalAsMeanIfOptimaAreEqual() {
    Estimate estimate = new Ratio(new double[] {1, 2, 3}, new double[] {10, 10, 10}).estimate();
    assertEquals(0.2, estimate.mean(), 1e-12);
    Estimate mean = Estimate.mean(new double[] {0.1, 0.2, 0.3});
    assertEquals(mean.low(), estimate.low(), 0.1);
    assertEquals(mean.high(), estimate.high(), 0.1);
  }

  @Test
  void textSaysIfEverySeedGivesSameValue() {
    Estimate same = new Ratio(new double[] {9, 9, 9}, new double[] {10, 10, 10}).estimate();
    assertEquals(new Estimate(0.9, 0.9, 0.9), same);
    assertEquals("0.90 in every seed", same.text("%.2f"));
    assertEquals("0.00 [0.00, 0.10]", new Estimate(-0.001, -0.004, 0.1).text("%.2f"));
    assertEquals("-0.10 [-1.00, -0.01]", new Estimate(-0.1, -1, -0.01).text("%.2f"));
    assertEquals("0.1 in every seed", Estimate.mean(new double[] {0.1, 0.1, 0.1}).text("%.1f"));
  }

  @Test
  void pairsDifferencesBySeed() {
    Ratio ratio = new Ratio(new double[] {5, 9}, new double[] {10, 10});
    Ratio other = new Ratio(new double[] {4, 8}, new double[] {10, 10});
    Estimate difference = ratio.minus(other);
    assertEquals(0.1, difference.mean(), 1e-12);
    assertEquals(0.1, difference.low(), 1e-12);
    assertEquals(0.1, difference.high(), 1e-12);
  }

  @Test
  void singleSeedHasNoInterval() {
    Estimate estimate = new Ratio(new double[] {9}, new double[] {10}).estimate();
    assertEquals(Estimate.single(0.9), estimate);
    assertEquals("0.90", estimate.text("%.2f"));
    assertEquals(Estimate.single(3), Estimate.mean(new double[] {Double.NaN, 3}));
  }

  @Test
  void isNaNWithoutOptimumAboveZero() {
    assertTrue(Double.isNaN(new Ratio(new double[] {0}, new double[] {0}).estimate().mean()));
  }
}
