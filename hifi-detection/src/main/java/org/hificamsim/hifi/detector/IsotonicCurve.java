package org.hificamsim.hifi.detector;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.Arrays;

/**
 * A curve that is linear between knots and constant before the first and after the last. It is the
 * result of isotonic regression, which assumes only that confidence does not fall.
 */
public final class IsotonicCurve implements DetectorModel {
  @JsonProperty private final double[][] knots;
  private final double[] pips;
  private final double[] confidences;

  /**
   * @param knots one or more rows of PIP and confidence; from row to row PIP rises and confidence
   *     does not fall
   * @throws IllegalArgumentException naming the first knot that breaks this rule
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
    if (Double.isNaN(pip)) {
      return pip;
    }
    int found = Arrays.binarySearch(pips, pip);
    if (found >= 0) {
      return confidences[found];
    }
    int after = -found - 1;
    if (after == 0 || after == pips.length) {
      return confidences[Math.max(0, after - 1)];
    }
    double share = (pip - pips[after - 1]) / (pips[after] - pips[after - 1]);
    return confidences[after - 1] + share * (confidences[after] - confidences[after - 1]);
  }

  @Override
  public String equation() {
    return pips.length + " knots";
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
