package org.hificamsim.hifi.model;

import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.registry.Registry;

/**
 * Registers the models that {@code profile boxes} fitted to public recordings: {@code
 * boxes:<detector>}. Each is a model file in this module's resources.
 */
public final class BoxDetections {
  private BoxDetections() {}

  /** Adds every model to a registry. */
  public static void register(Registry<DetectionModel> registry) {
    registry.register(
        "boxes:frcnn-2016",
        "Faster R-CNN on people, by pixel height and hidden share; two recordings",
        () -> model("boxes/frcnn-2016.json"));
  }

  private static DetectionModel model(String resource) {
    return ModelFiles.parse(resource, Io.resource(BoxDetections.class, resource));
  }
}
