package org.hificamsim.profiling.report;

import java.util.Locale;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.hifi.detector.HillCurve;
import org.hificamsim.hifi.detector.IsotonicCurve;
import org.hificamsim.hifi.detector.LogisticCurve;
import org.hificamsim.hifi.detector.SaturatingExponential;

/** Detector models as equations. */
final class Equations {
  private Equations() {}

  /** The equation, with PIP as p. */
  static String equation(DetectorModel g) {
    if (g instanceof DetectorLine line) {
      return said("%+.3g p %+.3g", line.slope(), line.intercept());
    }
    if (g instanceof SaturatingExponential curve) {
      return said("%.3g + %.3g (1 - exp(-p / %.3g))", curve.floor(), curve.rise(), curve.scale());
    }
    if (g instanceof HillCurve curve) {
      return said(
          "%.3g + %.3g / (1 + (%.3g / p)^%.3g)",
          curve.floor(), curve.rise(), curve.half(), curve.exponent());
    }
    if (g instanceof LogisticCurve curve) {
      return said("1 / (1 + (%.3g / p)^%.3g)", curve.half(), curve.exponent());
    }
    return g instanceof IsotonicCurve curve ? curve.size() + " knots" : g.toString();
  }

  private static String said(String format, Object... values) {
    return String.format(Locale.ROOT, format, values);
  }
}
