package org.hificamsim.profiling.measure;

import java.util.List;
import org.hificamsim.profiling.detector.RatioTest;

/**
 * How photos are measured.
 *
 * @param detectors as they are asked for, in the order of the columns
 * @param test which matches count
 * @param pip which pixels are the object's
 */
public record MeasureSettings(List<String> detectors, RatioTest test, PipReading pip) {
  public MeasureSettings {
    detectors = List.copyOf(detectors);
  }
}
