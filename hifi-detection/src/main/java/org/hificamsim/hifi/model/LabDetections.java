package org.hificamsim.hifi.model;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.registry.Registry;

/**
 * The names of the models that were fitted in the rendered laboratory by {@code profile}: {@code
 * lab:<detector>-<f>}. Each is a model file among this module's resources, read when it is asked
 * for and not before.
 */
public final class LabDetections {
  /** The detectors, by their short names. */
  public static final List<String> DETECTORS = List.of("orb", "sift", "surf");

  /** The feature abstractions by their short names, with what they are in words. */
  public static final Map<String, String> FEATURES = features();

  private LabDetections() {}

  /** Adds every model. */
  public static void register(Registry<DetectionModel> registry) {
    for (String detector : DETECTORS) {
      FEATURES.forEach(
          (f, title) ->
              registry.register(
                  "lab:" + detector + "-" + f,
                  detector.toUpperCase(Locale.ROOT)
                      + " line on the "
                      + title
                      + ", fitted in the lab",
                  () -> ModelFiles.resource("lab/" + detector + "-" + f + ".json")));
    }
  }

  private static Map<String, String> features() {
    Map<String, String> features = new LinkedHashMap<>();
    features.put("lin", "multiple linear regression");
    features.put("svr-rbf", "support vector regression, RBF kernel");
    features.put("sr", "symbolic regression");
    features.put("svr-lin", "support vector regression, linear kernel");
    features.put("power", "power law");
    features.put("pinhole", "pinhole camera");
    return java.util.Collections.unmodifiableMap(features);
  }
}
