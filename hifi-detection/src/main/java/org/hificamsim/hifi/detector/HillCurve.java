package org.hificamsim.hifi.detector;

import org.hificamsim.core.Texts;

/**
 * Hill's curve {@code floor + rise * PIP^n / (half^n + PIP^n)}: with an exponent n above 1 a target
 * has to be large enough before anything is gained.
 *
 * @param floor confidence where the target fills nothing of the image
 * @param rise what is gained in the end, above 0
 * @param half PIP at which half of that is gained, above 0
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
