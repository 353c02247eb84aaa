package org.hificamsim.reproduction.ladder;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.hificamsim.reproduction.ladder.LadderResult.RungComparison;
import org.hificamsim.runs.compare.RungScores;
import org.junit.jupiter.api.Test;

/** Tests order, choice and regret with made-up policies, with one seed unless stated. */
class RungComparisonTest {
  private static final int[] ONE = {0};

  private static RungScores scores(double... kMin) {
    return new RungScores(
        Arrays.stream(kMin).mapToObj(value -> new double[] {value}).toArray(double[][]::new),
        new double[] {9});
  }

  private static double tau(RungScores own, RungScores top) {
    return new RungComparison(own, top).tau(ONE);
  }

  @Test
  void tauIsOneForSameOrderAndMinusOneForReverse() {
    assertEquals(1, tau(scores(1, 2, 3), scores(10, 20, 90)));
    assertEquals(-1, tau(scores(1, 2, 3), scores(3, 2, 1)));
  }

  @Test
  void tauIsOneThirdForOneSwappedPairOfThree() {
    assertEquals(1.0 / 3, tau(scores(1, 2, 3), scores(1, 3, 2)), 1e-12);
  }

  @Test
  void tauIgnoresPairThatTiesOnOneSide() {
    assertEquals(2 / Math.sqrt(2 * 3), tau(scores(1, 1, 3), scores(1, 2, 3)), 1e-12);
    assertEquals(1, tau(scores(1, 1, 3), scores(2, 2, 5)), 1e-12);
  }

  @Test
  void tauIsNaNIfAllPoliciesTie() {
    assertTrue(Double.isNaN(tau(scores(0, 0, 0), scores(1, 2, 3))));
    assertTrue(Double.isNaN(tau(scores(1, 2, 3), scores(4, 4, 4))));
    assertTrue(Double.isNaN(tau(scores(0, 0), scores(0, 0))));
  }

  @Test
  void regretIsLossUnderTopRung() {
    RungComparison comparison = new RungComparison(scores(3, 2, 1), scores(0.5, 0.8, 0.1));
    assertEquals(0.3, comparison.regret(ONE), 1e-12);
    assertEquals(0.3 / 0.8, comparison.share(ONE), 1e-12);
  }

  @Test
  void rightChoiceHasNoRegret() {
    assertEquals(0, new RungComparison(scores(1, 9, 5), scores(0.1, 0.8, 0)).regret(ONE));
  }

  @Test
  void regretOfTiedChoicesIsMeanOfTheirRegrets() {
    RungComparison comparison = new RungComparison(scores(1, 1, 0), scores(0.4, 0.8, 0.9));
    assertEquals(0.9 - 0.6, comparison.regret(ONE), 1e-12);
    RungComparison allTied = new RungComparison(scores(0, 0, 0), scores(0.3, 0.6, 0.9));
    assertEquals(0.3, allTied.regret(ONE), 1e-12);
  }

  @Test
  void regretIsZeroWithoutShareIfTopRungCoversNothing() {
    RungComparison comparison = new RungComparison(scores(1, 2), scores(0, 0));
    assertEquals(0, comparison.regret(ONE));
    assertTrue(Double.isNaN(comparison.share(ONE)));
  }

  @Test
  void usesSameSeedsForBothRungs() {
    RungScores own = new RungScores(new double[][] {{1, 1}, {0, 0}}, new double[] {1, 1});
    RungScores top = new RungScores(new double[][] {{0.2, 0.6}, {0.3, 0.9}}, new double[] {1, 1});
    RungComparison comparison = new RungComparison(own, top);
    assertEquals(0.2, comparison.regret(new int[] {0, 1}), 1e-12);
    assertEquals(0.1, comparison.regret(new int[] {0, 0}), 1e-12);
    assertEquals(0.3, comparison.regret(new int[] {1, 1}), 1e-12);
  }

  @Test
  void choosesAgainForEachDraw() {
    RungScores own = new RungScores(new double[][] {{1, 0}, {0, 2}}, new double[] {1, 1});
    RungScores top = new RungScores(new double[][] {{0.2, 0.6}, {0.3, 0.1}}, new double[] {1, 1});
    RungComparison comparison = new RungComparison(own, top);
    assertEquals(0.2, comparison.regret(new int[] {0, 1}), 1e-12);
    assertEquals(0.1, comparison.regret(new int[] {0, 0}), 1e-12);
    assertEquals(0.5, comparison.regret(new int[] {1, 1}), 1e-12);
  }

  @Test
  void tiedPoliciesShareTheBetterRank() {
    assertArrayEquals(new int[] {2, 1, 2, 4}, scores(5, 7, 5, 1).ranks());
    assertArrayEquals(new int[] {0, 2}, scores(5, 1, 5).best());
  }
}
