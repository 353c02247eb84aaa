package org.hificamsim.profiling.measure;

import java.util.List;

/**
 * What became of a measurement.
 *
 * @param resumed photos that an earlier, unfinished call had measured already
 * @param threads that were used, as many as fit into the memory
 * @param warnings each in one line
 */
public record MeasureResult(int resumed, int threads, List<String> warnings) {
  public MeasureResult {
    warnings = List.copyOf(warnings);
  }
}
