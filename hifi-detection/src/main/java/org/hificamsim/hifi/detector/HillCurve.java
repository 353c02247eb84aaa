package org.hificamsim.hifi.detector;

import org.hificamsim.core.Texts;

/**
 * The Hill curve {@code floor + rise * PIP^n / (half^n + PIP^n)}. With an exponent n above 1 the
 * confidence rises only once a target is large enough.
 *
 * @param floor the confidence at a PIP of 0
 * @param rise how far the confidence rises above the floor in the limit, above 0
 * @param half the PIP at which half of the rise is reached, above 0
 * @param exponent n, above 0
 */
public record HillCurve(double floor, double rise, double half, double exponent)
    implements DetectorModel {
  @Override
  public double confidence(double pip) {
    return floor + rise / (1 + StrictMath.pow(half / pip, exponent));
  }

  @Override
  public String equation() {
    return Texts.format("%.3g + %.3g / (1 + (%.3g / p)^%.3g)", floor, rise, half, exponent);
  }
}
