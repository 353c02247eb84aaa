package org.hificamsim.agents.optimal;

import org.hificamsim.core.registry.Options;

/** The option {@code nodes}: how long the proof of a step may take. */
final class NodeLimit {
  /** By default; more than steps of some hundred cameras need, and seconds of search. */
  static final int DEFAULT = 1_000_000;

  private NodeLimit() {}

  static int from(Options options) {
    return from(options, DEFAULT);
  }

  static int from(Options options, int byDefault) {
    return options.integer(
        "nodes",
        byDefault,
        0,
        Integer.MAX_VALUE,
        "search nodes of a step before the best configuration found is taken, unproven");
  }
}
