package org.hificamsim.hifi.detector;

import org.hificamsim.core.Texts;

/**
 * The curve {@code floor + rise * (1 - exp(-PIP / scale))}, steepest at the start.
 *
 * @param floor the confidence at a PIP of 0
 * @param rise how far the confidence rises above the floor in the limit, above 0
 * @param scale the PIP at which 63% of the rise is reached, above 0
 */
public record SaturatingExponential(double floor, double rise, double scale)
    implements DetectorModel {
  @Override
  public double confidence(double pip) {
    return floor - rise * StrictMath.expm1(-pip / scale);
  }

  @Override
  public String equation() {
    return Texts.format("%.3g + %.3g (1 - exp(-p / %.3g))", floor, rise, scale);
  }
}
