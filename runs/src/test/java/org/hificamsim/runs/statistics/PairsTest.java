package org.hificamsim.runs.statistics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.hificamsim.runs.Estimate;
import org.junit.jupiter.api.Test;

/** Tests the statistics of pairs of policies. */
class PairsTest {
  @Test
  void probabilityOfImprovementCountsTiesHalfAndScenariosEqually() {
    Strata policy = Strata.of(List.of(new double[] {1, 2}, new double[] {5, 5, 5}));
    Strata other = Strata.of(List.of(new double[] {2, 0}, new double[] {1, 1, 1}));
    double first = (1 + 1 + 0.5) / 4; // 1 beats 0, 2 beats 0, 2 ties with 2
    assertEquals((first + 1) / 2, Aggregate.probability(policy, other), 1e-12);
    assertEquals(1 - (first + 1) / 2, Aggregate.probability(other, policy), 1e-12);
  }

  @Test
  void profileFallsToShareOfOptimalRuns() {
    Estimate[] shares = Aggregate.profile(Strata.of(List.of(new double[] {0, 0.25, 0.5, 1})));
    assertEquals(1, shares[0].mean());
    assertEquals(0.75, shares[25].mean());
    assertEquals(0.5, shares[26].mean());
    assertEquals(0.25, shares[100].mean());
    assertTrue(shares[50].low() < 0.5 && shares[50].high() > 0.5);
  }

  @Test
  void triesAllSignsOfFewDifferences() {
    assertEquals(0.25, PairedTest.p(new double[] {1, 1, 1}), 1e-12);
    assertEquals(0.75, PairedTest.p(new double[] {3, 1, -1}), 1e-12); // all but 3 - 1 - 1 reach 3
    assertEquals(1, PairedTest.p(new double[] {0, 0, 0, 0}), 1e-12);
  }

  @Test
  void drawsSignsOfManyDifferences() {
    double[] all = new double[40];
    Arrays.fill(all, 0.1);
    assertEquals(1e-5, PairedTest.p(all), 1e-12);
    double[] balanced = new double[40];
    Arrays.setAll(balanced, i -> i % 2 == 0 ? 0.1 : -0.1);
    assertEquals(1, PairedTest.p(balanced), 1e-12);
  }

  @Test
  void drawnSignsAgreeWithAllSigns() {
    double[] few = new double[PairedTest.MAX_EXACT];
    Arrays.setAll(few, i -> Math.sin(i) + 0.3);
    double[] withZeros = Arrays.copyOf(few, PairedTest.MAX_EXACT + 70); // zeros change nothing
    assertEquals(PairedTest.p(few), PairedTest.p(withZeros), 0.005);
  }

  @Test
  void singleDifferenceHasNoPValue() {
    assertTrue(Double.isNaN(PairedTest.p(new double[] {1})));
  }

  @Test
  void holmMultipliesSmallestPValueByNumberOfTests() {
    double[] p = {0.04, 0.01, Double.NaN, 0.03, 0.02, 0.5};
    assertArrayEquals(
        new double[] {0.09, 0.05, Double.NaN, 0.09, 0.08, 0.5}, PairedTest.corrected(p), 1e-12);
    assertEquals(5, PairedTest.tests(p), "NaN is no test");
    assertArrayEquals(new double[] {1, 1}, PairedTest.corrected(new double[] {0.6, 0.7}));
  }

  @Test
  void computesSeedsThatDifferenceNeeds() {
    assertEquals(6, PairedTest.leastSeeds(1));
    assertEquals(10, PairedTest.leastSeeds(25));
    assertEquals(13, PairedTest.leastSeeds(135));
    // R: power.t.test(delta = 1, sd = 1, power = .8, type = "paired") needs 9.94 pairs
    double[] scattered = {1 - Math.sqrt(0.9), 1 + Math.sqrt(0.9)};
    double[] differences = new double[10];
    Arrays.setAll(differences, i -> scattered[i % 2]);
    assertEquals(10, PairedTest.seedsNeeded(differences, 1));
    assertTrue(PairedTest.seedsNeeded(differences, 100) > 20);
    assertTrue(Double.isNaN(PairedTest.seedsNeeded(new double[] {0, 0}, 1)));
  }
}
