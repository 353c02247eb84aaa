package org.hificamsim.profiling.measure;

import java.util.List;
import org.hificamsim.profiling.detector.Detectors;
import org.hificamsim.profiling.detector.RatioTest;

/**
 * How photos are measured.
 *
 * @param detectors as they are asked for, in the order of the columns
 * @param test which matches count
 * @param pip which pixels are the object's
 * @param falseAlarms the share of the photos without the object that may be taken for it, [0, 1)
 */
public record MeasureSettings(
    List<String> detectors, RatioTest test, PipReading pip, double falseAlarms) {
  public MeasureSettings {
    detectors = List.copyOf(detectors);
  }

  /** The columns that are filled photo by photo. */
  List<String> columns() {
    return detectors.stream().map(Detectors::column).toList();
  }
}
