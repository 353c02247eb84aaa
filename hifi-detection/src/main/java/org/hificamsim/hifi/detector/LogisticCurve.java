package org.hificamsim.hifi.detector;

import org.hificamsim.core.Texts;

/**
 * The logistic curve in log PIP, {@code 1 / (1 + (half / PIP)^n)}: from 0 to 1, whatever was
 * measured.
 *
 * @param half PIP at which the confidence is one half, above 0
 * @param exponent n, what a factor e of PIP adds to the logarithm of the odds, above 0
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
