package org.hificamsim.hifi.detector;

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
    return curve().confidence(pip);
  }

  @Override
  public double pip(double confidence) {
    return curve().pip(confidence);
  }

  private HillCurve curve() {
    return new HillCurve(0, 1, half, exponent);
  }
}
