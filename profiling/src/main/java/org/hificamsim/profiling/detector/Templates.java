package org.hificamsim.profiling.detector;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.parallel.Parallel;

/** The features of each object's template, its close-up. */
public final class Templates implements AutoCloseable {
  private final Map<String, Map<FeatureDetector, Features>> objects = new LinkedHashMap<>();
  private final List<String> warnings = new ArrayList<>();

  /**
   * Finds the features.
   *
   * @param files the close-up of each object, by the object's name
   */
  public Templates(Map<String, Path> files, List<FeatureDetector> detectors, int threads) {
    List<String> names = List.copyOf(files.keySet());
    List<Map<FeatureDetector, Features>> found =
        Parallel.map(names, threads, name -> features(files.get(name), detectors));
    for (int i = 0; i < names.size(); i++) {
      objects.put(names.get(i), found.get(i));
      warnIfEmpty(files.get(names.get(i)), found.get(i));
    }
  }

  private static Map<FeatureDetector, Features> features(
      Path file, List<FeatureDetector> detectors) {
    Map<FeatureDetector, Features> features = new LinkedHashMap<>();
    try (Photograph close = new Photograph(file)) {
      for (FeatureDetector detector : detectors) {
        features.put(
            detector,
            close.detect(detector.word(), () -> detector.extractor().features(close.grey())));
      }
    }
    return features;
  }

  private void warnIfEmpty(Path file, Map<FeatureDetector, Features> found) {
    found.forEach(
        (detector, features) -> {
          if (features.count() == 0) {
            warnings.add(
                "%s: %s finds no feature in this template, so that its confidence is 0 in every photo, expected a close-up with texture"
                    .formatted(file, detector.word()));
          }
        });
  }

  /** Returns the features that a detector finds in an object's template. */
  public Features features(String object, FeatureDetector detector) {
    return objects.get(object).get(detector);
  }

  /** Returns a line for each template in which a detector finds no features. */
  public List<String> warnings() {
    return warnings;
  }

  @Override
  public void close() {
    objects.values().forEach(features -> features.values().forEach(Features::close));
  }
}
