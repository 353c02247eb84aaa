package org.hificamsim.hifi.detector;

import org.hificamsim.core.Texts;

/**
 * A detector model g: the line {@code confidence = slope * PIP + intercept} that was fitted to one
 * detector's confidences, on measured PIP (Eqs 5.2-5.4) or on an abstraction's PIP (Table 6.1).
 *
 * @param slope confidence gained from an empty to a full image
 * @param intercept confidence where the target fills nothing of the image
 */
public record DetectorLine(double slope, double intercept) implements DetectorModel {
  @Override
  public double confidence(double pip) {
    return slope * pip + intercept;
  }

  /** The PIP at which the line takes this confidence; not finite for a level line. */
  public double pip(double confidence) {
    return (confidence - intercept) / slope;
  }

  @Override
  public String equation() {
    return Texts.format("%+.3g p %+.3g", slope, intercept);
  }
}
