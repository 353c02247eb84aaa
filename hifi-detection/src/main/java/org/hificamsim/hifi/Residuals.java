package org.hificamsim.hifi;

import com.fasterxml.jackson.annotation.JsonIgnore;
import org.hificamsim.core.detection.Scatter;
import org.hificamsim.hifi.detector.DetectorModel;

/**
 * How far measured confidences lie from a detector model g. Their standard deviation is {@code
 * least} where the target fills nothing of the image, and grows by {@code growth} for each unit
 * that g gains; by 0 where one number is all that is known.
 *
 * @param rmse root mean squared error over all photos, above 0
 * @param least above 0
 * @param growth 0 or more
 */
public record Residuals(@JsonIgnore double rmse, double least, double growth) {
  /** The same everywhere. */
  public static Residuals of(double rmse) {
    return new Residuals(rmse, rmse, 0);
  }

  /** Whether they scatter more where g is larger. */
  public boolean grow() {
    return growth > 0;
  }

  /** Their scatter about this g. */
  public Scatter about(DetectorModel g) {
    return new Scatter(g.confidence(0), rmse, least, growth);
  }
}
