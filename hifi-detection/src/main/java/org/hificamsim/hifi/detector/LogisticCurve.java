package org.hificamsim.hifi.detector;

import org.hificamsim.core.Texts;

/**
 * The logistic curve in log PIP, {@code 1 / (1 + (half / PIP)^n)}. It runs from 0 to 1 for any
 * measurements.
 *
 * @param half PIP at which the confidence is one half, above 0
 * @param exponent n, the increase of the log odds when PIP grows by a factor of e, above 0
 */
public record LogisticCurve(double half, double exponent) implements DetectorModel {
  @Override
  public double confidence(double pip) {
    return 1 / (1 + StrictMath.pow(half / pip, exponent));
  }

  @Override
  public String equation() {
    return Texts.format("1 / (1 + (%.3g / p)^%.3g)", half, exponent);
  }
}
