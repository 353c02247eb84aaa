package org.hificamsim.core.detection.camsim;

import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.registry.Registry;

/** The detection models of CamSim and the coverage study, by name. */
public final class CamSimDetections {
  private CamSimDetections() {}

  /** Adds these models to a registry. */
  public static Registry<DetectionModel> register(Registry<DetectionModel> registry) {
    return registry
        .register(
            "camsim-standard", "falls with the zoom radius (Eq 6.2)", CamSimStandardDetection::new)
        .register(
            "camsim-range",
            "falls with zoom radius and distance (coverage study)",
            CamSimRangeDetection::new)
        .register(
            "camsim-visibility",
            "CamSim's own visibility, distance and angle",
            CamSimVisibilityDetection::new);
  }
}
