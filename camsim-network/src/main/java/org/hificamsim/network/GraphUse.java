package org.hificamsim.network;

import java.util.Arrays;
import java.util.Optional;

/** What becomes of a scenario's vision graph: CamSim's option {@code -v} (behaviour 3.6). */
public enum GraphUse {
  AS_IN_FILE(-1),
  STATIC(0),
  IGNORED(1),
  CHANGING(2);

  private final int number;

  GraphUse(int number) {
    this.number = number;
  }

  /** The use of this number. */
  public static Optional<GraphUse> find(int number) {
    return Arrays.stream(values()).filter(use -> use.number == number).findFirst();
  }

  /** Whether the graph counts as static. */
  boolean isStatic(boolean inFile) {
    return this == STATIC || (this == AS_IN_FILE && inFile);
  }
}
