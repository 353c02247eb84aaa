package org.hificamsim.profiling.measure;

import java.util.List;
import java.util.Set;
import org.hificamsim.profiling.detector.RatioTest;

/**
 * How photos are measured.
 *
 * @param detectors by name, in the order of the columns
 * @param test which matches count
 * @param pip which pixels are the object's
 * @param pictures images of the data set whose matches are drawn (Figures 5.2, 5.4, 5.6)
 */
public record MeasureSettings(
    List<String> detectors, RatioTest test, PipReading pip, Set<String> pictures) {
  public MeasureSettings {
    detectors = List.copyOf(detectors);
    pictures = Set.copyOf(pictures);
  }
}
