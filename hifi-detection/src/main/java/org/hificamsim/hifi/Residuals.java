package org.hificamsim.hifi;

import com.fasterxml.jackson.annotation.JsonIgnore;
import org.hificamsim.core.detection.Scatter;
import org.hificamsim.hifi.detector.DetectorModel;

/**
 * The scatter of measured confidences about a detector model g. Their standard deviation is {@code
 * least} at a PIP of 0 and grows by {@code growth} per unit by which g rises; {@code growth} is 0
 * if only one number is known.
 *
 * @param rmse root mean squared error over all photos, above 0
 * @param least the standard deviation at a PIP of 0, above 0
 * @param growth the growth of the standard deviation per unit of confidence, 0 or more
 */
public record Residuals(@JsonIgnore double rmse, double least, double growth) {
  /** Returns residuals with the same standard deviation at every PIP. */
  public static Residuals of(double rmse) {
    return new Residuals(rmse, rmse, 0);
  }

  /** Whether the residuals scatter more where g is larger. */
  public boolean grow() {
    return growth > 0;
  }

  /** Returns the scatter about {@code g}. */
  public Scatter about(DetectorModel g) {
    return new Scatter(g.confidence(0), rmse, least, growth);
  }
}
