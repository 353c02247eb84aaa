package org.hificamsim.hifi.model;

import java.util.List;
import java.util.Locale;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.hifi.FittedDetection;

/**
 * Registers the models that {@code profile} fitted in the rendered laboratory: {@code
 * lab:<detector>-<f>}. Each is a model file in this module's resources, which is read when the
 * model is first used.
 */
public final class LabDetections {
  private LabDetections() {}

  /** Adds every model to a registry. */
  public static void register(Registry<DetectionModel> registry) {
    for (String detector : List.of("orb", "sift", "surf")) {
      register(registry, detector, "lin", "multiple linear regression");
      register(registry, detector, "svr-rbf", "support vector regression, RBF kernel");
      register(registry, detector, "sr", "symbolic regression");
      register(registry, detector, "svr-lin", "support vector regression, linear kernel");
      register(registry, detector, "power", "power law");
      register(registry, detector, "pinhole", "pinhole camera");
    }
  }

  private static void register(
      Registry<DetectionModel> registry, String detector, String f, String title) {
    String model = detector + "-" + f;
    registry.register(
        "lab:" + model,
        detector.toUpperCase(Locale.ROOT)
            + " on the "
            + title
            + ", fitted in the rendered laboratory",
        () -> model("lab/" + model + ".json"));
  }

  private static FittedDetection model(String resource) {
    return ModelFiles.parse(resource, Io.resource(LabDetections.class, resource));
  }
}
