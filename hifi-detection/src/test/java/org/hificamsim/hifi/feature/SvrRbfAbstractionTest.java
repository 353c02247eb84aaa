package org.hificamsim.hifi.feature;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import org.hificamsim.hifi.feature.SvrRbfAbstraction.Range;
import org.junit.jupiter.api.Test;

class SvrRbfAbstractionTest {
  private static final Range Q = new Range(0.1, 0.5);
  private static final Range D = new Range(0, 10);
  private static final Range Z = new Range(0.01, 0.09);

  private final SvrRbfAbstraction f =
      with(new double[] {0.1, 0, 0.01, 2}, new double[] {0.5, 10, 0.09, -3});

  @Test
  void equalsTheSumComputedByHand() {
    // Scaled to (0.5, 0.5, 0.5): both support vectors are at squared distance 0.75.
    assertEquals(1.5 - Math.exp(-0.25), f.negativeLogPip(0.3, 5, 0.05), 1e-15);
    // On the first one; the second is at squared distance 3.
    assertEquals(1.5 + 2 - 3 * Math.exp(-1), f.negativeLogPip(0.1, 0, 0.01), 1e-15);
  }

  @Test
  void rangesMapTheTrainingDataToZeroAndOne() {
    assertEquals(0, Q.scale(0.1));
    assertEquals(0.5, Q.scale(0.3), 1e-15);
    assertEquals(1, Q.scale(0.5));
    assertEquals(1.5, Q.scale(0.7), 1e-15);
  }

  @Test
  void approachesTheInterceptFarFromTheData() {
    assertEquals(1.5, f.negativeLogPip(0.3, 1e3, 0.05));
  }

  @Test
  void equalsOnlyTheSameNumbers() {
    assertEquals(f, with(f.support()));
    assertEquals(f.hashCode(), with(f.support()).hashCode());
    assertNotEquals(f, with(new double[] {0.1, 0, 0.01, 2}));
  }

  @Test
  void changesToItsArraysHaveNoEffect() {
    f.support()[0][3] = 99;
    assertEquals(2, f.support()[0][3]);
  }

  private static SvrRbfAbstraction with(double[]... support) {
    return new SvrRbfAbstraction(1.0 / 3, 1.5, Q, D, Z, support);
  }
}
