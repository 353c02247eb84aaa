package org.hificamsim.profiling.dataset;

import java.util.List;
import java.util.Optional;

/**
 * A data set as far as it could be read.
 *
 * @param dataset there when there are no problems
 * @param problems each in one line: {@code FILE:LINE:COLUMN: what is wrong, the value, what was
 *     expected}
 */
public record DatasetReading(Optional<Dataset> dataset, List<String> problems) {
  public DatasetReading {
    problems = List.copyOf(problems);
  }
}
