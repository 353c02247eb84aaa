package org.hificamsim.hifi.detector;

/**
 * A detector model g: the line {@code confidence = slope * PIP + intercept} that was fitted to one
 * detector's confidences, on measured PIP (Eqs 5.2-5.4) or on an abstraction's PIP (Table 6.1).
 *
 * @param slope confidence gained from an empty to a full image
 * @param intercept confidence where the target fills nothing of the image
 */
public record DetectorLine(double slope, double intercept) {
  /** The confidence at a PIP in [0, 1], not clamped. */
  public double confidence(double pip) {
    return slope * pip + intercept;
  }

  /** The PIP at which the line takes this confidence; not finite for a level line. */
  public double pip(double confidence) {
    return (confidence - intercept) / slope;
  }
}
