package org.hificamsim.hifi.detector;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.Arrays;

/**
 * A curve through knots, straight in between and level before the first and after the last: what
 * isotonic regression finds, which supposes nothing but that confidence does not fall.
 */
public final class IsotonicCurve implements DetectorModel {
  @JsonProperty private final double[][] knots;
  private final double[] pips;
  private final double[] confidences;

  /**
   * @param knots PIP and confidence of each, one knot or more; PIP rises from each to the next, and
   *     confidence does not fall
   * @throws IllegalArgumentException naming the knot where that is not so
   */
  public IsotonicCurve(double[][] knots) {
    this.knots = Arrays.stream(knots).map(double[]::clone).toArray(double[][]::new);
    this.pips = Arrays.stream(knots).mapToDouble(knot -> knot[0]).toArray();
    this.confidences = Arrays.stream(knots).mapToDouble(knot -> knot[1]).toArray();
    for (int i = 1; i < pips.length; i++) {
      if (!(pips[i] > pips[i - 1] && confidences[i] >= confidences[i - 1])) {
        throw new IllegalArgumentException(
            "expected PIP to rise and confidence not to fall at knot " + (i + 1));
      }
    }
  }

  @Override
  public double confidence(double pip) {
    return Double.isNaN(pip) ? pip : between(pips, confidences, pip);
  }

  @Override
  public double pip(double confidence) {
    if (confidence <= confidences[0]) {
      return 0;
    }
    int after = 0;
    while (after < confidences.length && confidences[after] < confidence) {
      after++;
    }
    return after == confidences.length
        ? Double.POSITIVE_INFINITY
        : segment(confidences, pips, after, confidence);
  }

  @Override
  public String equation() {
    return pips.length + " knots";
  }

  private static double between(double[] x, double[] y, double at) {
    int found = Arrays.binarySearch(x, at);
    int after = -found - 1;
    if (found >= 0) {
      return y[found];
    }
    return after == 0 ? y[0] : after == x.length ? y[x.length - 1] : segment(x, y, after, at);
  }

  private static double segment(double[] x, double[] y, int after, double at) {
    double share = (at - x[after - 1]) / (x[after] - x[after - 1]);
    return y[after - 1] + share * (y[after] - y[after - 1]);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof IsotonicCurve that && Arrays.deepEquals(knots, that.knots);
  }

  @Override
  public int hashCode() {
    return Arrays.deepHashCode(knots);
  }

  @Override
  public String toString() {
    return "isotonic with " + knots.length + " knots";
  }
}
