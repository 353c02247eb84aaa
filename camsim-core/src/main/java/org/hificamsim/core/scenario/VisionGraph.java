package org.hificamsim.core.scenario;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The links between cameras that a scenario starts with.
 *
 * @param isStatic the file's {@code static} attribute
 * @param neighbours names linked to, by camera name, in document order; names need not exist
 */
public record VisionGraph(boolean isStatic, Map<String, List<String>> neighbours) {
  /** Copies what could change. */
  public VisionGraph {
    neighbours = Collections.unmodifiableMap(new LinkedHashMap<>(neighbours));
  }
}
