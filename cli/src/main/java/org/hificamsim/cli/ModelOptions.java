package org.hificamsim.cli;

import java.util.Optional;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.runs.DetectionSpec;
import picocli.CommandLine.Option;

/** {@code --detection} and {@code --policy}: what a run is about. */
final class ModelOptions {
  @Option(
      names = "--detection",
      paramLabel = "NAME|FILE.json[@T|@RULE]",
      description =
          "The detection model, perhaps with its threshold or rule (--detect); see 'list"
              + " detections'.")
  private String detection;

  @Option(
      names = "--policy",
      paramLabel = "NAME[:key=value,...]",
      description = "The zoom policy; see 'list policies'.")
  private Optional<String> policy;

  /** The detection as it was written. */
  String detection() {
    return detection;
  }

  /** The detection with its model. */
  DetectionSpec detection(Catalogue catalogue) {
    return DetectionSpec.parse(detection, catalogue::detection);
  }

  /** The policy's name and options; empty where neither the user nor a default names one. */
  Optional<String> policy() {
    return policy;
  }
}
