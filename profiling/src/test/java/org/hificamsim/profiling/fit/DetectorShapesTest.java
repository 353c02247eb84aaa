package org.hificamsim.profiling.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.hifi.detector.HillCurve;
import org.hificamsim.hifi.detector.LogisticCurve;
import org.hificamsim.hifi.detector.SaturatingExponential;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Compares every shape of g with SciPy and scikit-learn. With the twelve rows below as {@code p}
 * and {@code y}, and {@code e = np.exp}:
 *
 * <pre>
 * fit = lambda f, s: least_squares(lambda t: f(t) - y, s, xtol=1e-15, ftol=1e-15, gtol=1e-15)
 * fit(lambda t: t[0] + e(t[1]) * (1 - e(-p / e(t[2]))), [0, -1, -3])
 * fit(lambda t: t[0] + e(t[1]) / (1 + (e(t[2]) / p) ** e(t[3])), [0, -1, -3, 0])
 * fit(lambda t: 1 / (1 + (e(t[0]) / p) ** e(t[1])), [-3, 0])
 * sklearn.isotonic.IsotonicRegression().fit(p, y).y_thresholds_
 * </pre>
 */
class DetectorShapesTest {
  private static final double[] PIP = {
    0.0005, 0.001, 0.002, 0.004, 0.008, 0.012, 0.02, 0.03, 0.05, 0.08, 0.12, 0.2
  };
  private static final double[] CONFIDENCE = {
    0.03, 0.02, 0.06, 0.05, 0.14, 0.17, 0.30, 0.33, 0.47, 0.52, 0.50, 0.55
  };

  @Test
  void saturatingExponentialEqualsSciPy() {
    SaturatingExponential g = (SaturatingExponential) fit("saturating-exponential");
    assertEquals(0.006337526114639778, g.floor(), 1e-6);
    assertEquals(0.5326321227675134, g.rise(), 1e-6);
    assertEquals(0.028394491956950384, g.scale(), 1e-6);
    assertEquals(0.004572103575461832, squaredError(g), 1e-11);
  }

  @Test
  void hillCurveEqualsSciPy() {
    HillCurve g = (HillCurve) fit("hill");
    assertEquals(0.028054137250032012, g.floor(), 1e-5);
    assertEquals(0.5323594114073175, g.rise(), 1e-5);
    assertEquals(0.021282692600077008, g.half(), 1e-5);
    assertEquals(1.5593905972193025, g.exponent(), 1e-5);
    assertEquals(0.004224920272406703, squaredError(g), 1e-11);
  }

  @Test
  void logisticCurveEqualsSciPy() {
    LogisticCurve g = (LogisticCurve) fit("logistic");
    assertEquals(0.09580887066914413, g.half(), 1e-5);
    assertEquals(0.6639077627877461, g.exponent(), 1e-5);
    assertEquals(0.021895695567932395, squaredError(g), 1e-11);
  }

  @Test
  void isotonicCurveEqualsScikitLearn() {
    DetectorModel g = fit("isotonic");
    double[] expected = {
      0.025, 0.025, 0.055, 0.055, 0.14, 0.17, 0.30, 0.33, 0.47, 0.51, 0.51, 0.55
    };
    for (int i = 0; i < PIP.length; i++) {
      assertEquals(expected[i], g.confidence(PIP[i]), 1e-12, "at " + PIP[i]);
    }
  }

  /**
   * Checks two rows with a PIP of 0.02 in both orders, with values from {@code IsotonicRegression}.
   */
  @Test
  void averagesConfidencesOfEqualPips() {
    double[] pip = {0.01, 0.02, 0.02, 0.03, 0.05, 0.04};
    double[] confidence = {0.3, 0.1, 0.7, 0.2, 0.9, 0.95};
    DetectorModel g = DetectorShape.of("isotonic").fit(pip, confidence);
    assertEquals(0.3, g.confidence(0.01), 1e-12);
    assertEquals(1.0 / 3, g.confidence(0.02), 1e-12);
    assertEquals(1.0 / 3, g.confidence(0.03), 1e-12);
    assertEquals(0.925, g.confidence(0.04), 1e-12);
    assertEquals(0.925, g.confidence(0.05), 1e-12);
  }

  @ParameterizedTest
  @ValueSource(strings = {"saturating-exponential", "hill", "logistic", "isotonic"})
  void fallingConfidencesGiveNoFallingModel(String shape) {
    double[] falling = Arrays.stream(CONFIDENCE).map(c -> 0.6 - c).toArray();
    DetectorModel g = DetectorShape.of(shape).fit(PIP, falling);
    double before = g.confidence(0);
    for (double pip = 1e-4; pip <= 1; pip *= 1.1) {
      assertTrue(g.confidence(pip) >= before, shape + " at " + pip);
      before = g.confidence(pip);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"line", "saturating-exponential", "hill", "logistic", "isotonic"})
  void fitsDataWithOnePip(String shape) {
    double[] same = new double[CONFIDENCE.length];
    Arrays.fill(same, 0.05);
    double mean = Arrays.stream(CONFIDENCE).average().orElseThrow();
    DetectorModel g = DetectorShape.of(shape).fit(same, CONFIDENCE);
    assertEquals(mean, g.confidence(0.05), 1e-3, shape);
  }

  @Test
  void rejectsUnknownShapeAndListsKnownOnes() {
    InputException refused = assertThrows(InputException.class, () -> DetectorShape.of("spline"));
    assertTrue(refused.getMessage().contains("'spline'"), refused.getMessage());
    assertTrue(refused.getMessage().contains("line, logistic"), refused.getMessage());
    assertEquals(
        List.of("line", "logistic", "saturating-exponential", "hill", "isotonic"),
        DetectorShape.names());
  }

  private static DetectorModel fit(String shape) {
    return DetectorShape.of(shape).fit(PIP, CONFIDENCE);
  }

  private static double squaredError(DetectorModel g) {
    double sum = 0;
    for (int i = 0; i < PIP.length; i++) {
      sum += Math.pow(g.confidence(PIP[i]) - CONFIDENCE[i], 2);
    }
    return sum;
  }
}
