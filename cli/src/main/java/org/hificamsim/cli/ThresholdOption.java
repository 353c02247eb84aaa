package org.hificamsim.cli;

import java.util.Optional;
import picocli.CommandLine.Option;

/** {@code --threshold}. */
final class ThresholdOption {
  @Option(
      names = "--threshold",
      paramLabel = "T",
      description =
          "Detection threshold, 0 to 1; default: that of NAME@T, the scenario's, else the model's.")
  private Optional<Double> threshold;

  /** What was asked for. */
  Optional<Double> value() {
    return threshold;
  }
}
