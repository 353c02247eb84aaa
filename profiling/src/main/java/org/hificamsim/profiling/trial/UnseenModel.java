package org.hificamsim.profiling.trial;

import java.util.Optional;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.hifi.HiFiDetection;

/**
 * A model that has not seen some photos, as the simulator uses it. A {@link Detection} remembers a
 * table for each size and zoom level; where every photo has its own, that is too much to keep.
 */
final class UnseenModel {
  private static final int MAX_USES = 256;

  private final HiFiDetection model;
  private final double threshold;
  private int uses;
  private Detection certain;
  private Optional<Detection> chance;

  UnseenModel(HiFiDetection model, double threshold) {
    this.model = model;
    this.threshold = threshold;
  }

  /** Begins another scene. */
  void begin() {
    if (uses++ % MAX_USES == 0) {
      certain = new Detection(model, threshold);
      chance =
          model
              .scatter()
              .map(any -> Detection.by(DetectionRule.parse("chance"), model.name(), model));
    }
  }

  /** By the threshold. */
  Detection certain() {
    return certain;
  }

  /** By chance; empty where the model has no scatter. */
  Optional<Detection> chance() {
    return chance;
  }
}
