package org.hificamsim.hifi.detector;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Compares curves with values from NumPy, and tests properties of every shape. */
class DetectorModelTest {
  private static final double[] PIPS = {0, 0.001, 0.03, 0.5};

  static Stream<DetectorModel> shapes() {
    return Stream.of(
        new DetectorLine(0.6, 0.02),
        new SaturatingExponential(0.02, 0.6, 0.05),
        new HillCurve(0.02, 0.6, 0.04, 1.5),
        new LogisticCurve(0.04, 1.5),
        new IsotonicCurve(new double[][] {{0.001, 0.05}, {0.02, 0.2}, {0.1, 0.7}}));
  }

  /**
   * By numpy: {@code 0.02+0.6*(1-np.exp(-p/0.05))}, {@code 0.02+0.6*p**1.5/(0.04**1.5+p**1.5)},
   * {@code scipy.special.expit(1.5*(np.log(p)-np.log(0.04)))} and {@code
   * np.interp(p,[0.001,0.02,0.1],[0.05,0.2,0.7])}.
   */
  @Test
  void curvesEqualThoseOfNumPy() {
    List<DetectorModel> shapes = shapes().toList();
    check(shapes.get(1), 0.02, 0.03188079601594685, 0.29071301834358415, 0.6199727600421425);
    check(shapes.get(2), 0.02, 0.02236237015715999, 0.2562576115943738, 0.6067239524648803);
    check(shapes.get(3), 0, 0.003937283595266649, 0.39376268599062303, 0.977873254108134);
    check(shapes.get(4), 0.05, 0.05, 0.2625, 0.7);
  }

  @ParameterizedTest
  @MethodSource("shapes")
  void confidenceIsFiniteAndNeverFalls(DetectorModel g) {
    double before = g.confidence(0);
    for (double pip = 1e-12; pip <= 1; pip *= 1.01) {
      double here = g.confidence(pip);
      assertTrue(here >= before && Double.isFinite(here), g + " at " + pip + ": " + here);
      before = here;
    }
    assertTrue(Double.isNaN(g.confidence(Double.NaN)), g.toString());
  }

  @Test
  void rejectsKnotsOutOfOrder() {
    for (double[][] knots :
        List.of(
            new double[][] {{0.1, 0.2}, {0.1, 0.3}},
            new double[][] {{0.1, 0.2}, {0.2, 0.1}},
            new double[][] {{0.2, 0.2}, {0.1, 0.3}})) {
      IllegalArgumentException refused =
          assertThrows(IllegalArgumentException.class, () -> new IsotonicCurve(knots));
      assertTrue(refused.getMessage().contains("knot 2"), refused.getMessage());
    }
  }

  @Test
  void curvesWithEqualKnotsAreEqual() {
    double[][] knots = {{0.1, 0.2}, {0.2, 0.3}};
    IsotonicCurve curve = new IsotonicCurve(knots);
    knots[0][0] = 0.15;
    assertEquals(new IsotonicCurve(new double[][] {{0.1, 0.2}, {0.2, 0.3}}), curve);
    assertEquals(
        new IsotonicCurve(new double[][] {{0.1, 0.2}, {0.2, 0.3}}).hashCode(), curve.hashCode());
    assertNotEquals(new IsotonicCurve(knots), curve);
    assertEquals("2 knots", curve.equation());
  }

  private static void check(DetectorModel g, double... expected) {
    for (int i = 0; i < PIPS.length; i++) {
      assertEquals(expected[i], g.confidence(PIPS[i]), 1e-15, g + " at " + PIPS[i]);
    }
  }
}
