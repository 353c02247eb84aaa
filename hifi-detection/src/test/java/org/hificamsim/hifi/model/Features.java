package org.hificamsim.hifi.model;

import java.util.List;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.hifi.feature.FeatureAbstraction;

/** Finds entries of the catalogue for tests. */
final class Features {
  private Features() {}

  static FeatureAbstraction abstraction(String name) {
    return feature(name).f();
  }

  static PublishedModels.Feature feature(String name) {
    return PublishedModels.published().features().stream()
        .filter(feature -> feature.name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  static Registry<DetectionModel> registry() {
    Registry<DetectionModel> registry = new Registry<>("detection");
    HiFiDetections.register(registry);
    return registry;
  }

  static List<String> registered() {
    return registry().names();
  }
}
