package org.hificamsim.hifi.detector;

import org.hificamsim.core.Texts;

/**
 * A detector model g: the line {@code confidence = slope * PIP + intercept} that was fitted to one
 * detector's confidences, on measured PIP (Eqs 5.2-5.4) or on an abstraction's PIP (Table 6.1).
 *
 * @param slope the increase in confidence from a PIP of 0 to a PIP of 1
 * @param intercept the confidence at a PIP of 0
 */
public record DetectorLine(double slope, double intercept) implements DetectorModel {
  @Override
  public double confidence(double pip) {
    return slope * pip + intercept;
  }

  /** Returns the PIP at which the line has this confidence; not finite if the slope is 0. */
  public double pip(double confidence) {
    return (confidence - intercept) / slope;
  }

  @Override
  public String equation() {
    return Texts.format("%+.3g p %+.3g", slope, intercept);
  }
}
