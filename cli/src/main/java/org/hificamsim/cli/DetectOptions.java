package org.hificamsim.cli;

import java.util.Optional;
import org.hificamsim.core.detection.DetectionRule;
import picocli.CommandLine.Option;

/** {@code --threshold} and {@code --detect}: when a target counts as detected. */
final class DetectOptions {
  @Option(
      names = "--threshold",
      paramLabel = "T",
      description =
          "Detection threshold, 0 to 1; default: that of NAME@T, the scenario's, else the model's.")
  private Optional<Double> threshold;

  @Option(
      names = "--detect",
      paramLabel = "RULE",
      description = {
        "How a confidence becomes a detection: threshold; chance, drawn from the scatter of the"
            + " model's fit; or probability, the value itself.",
        "With options: chance:alpha=0.05,memory=N,phantoms=on. Default: the scenario's, else"
            + " threshold."
      })
  private Optional<String> detect;

  /** The threshold that was asked for. */
  Optional<Double> threshold() {
    return threshold;
  }

  /** The rule that was asked for. */
  Optional<DetectionRule> rule() {
    return detect.map(DetectionRule::parse);
  }
}
