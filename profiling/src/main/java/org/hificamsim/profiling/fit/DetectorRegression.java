package org.hificamsim.profiling.fit;

import org.hificamsim.hifi.detector.DetectorModel;

/** A way to fit a detector model g: an extension point; a line in {@link DetectorShapes}. */
public interface DetectorRegression {
  /** The short name, as the model file's type says it. */
  String name();

  /**
   * Fits confidences on PIP; the same for the same rows.
   *
   * @param pip the share of the image of each row, [0, 1]
   * @param confidence what was measured of it
   * @throws org.hificamsim.core.InputException when there are fewer than three rows
   */
  DetectorModel fit(double[] pip, double[] confidence);
}
