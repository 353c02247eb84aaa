package org.hificamsim.profiling.detector;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.parallel.Parallel;

/** The features of each object, from its close-up. */
public final class Templates implements AutoCloseable {
  private final Map<String, Known> objects = new LinkedHashMap<>();

  private record Known(Path file, Map<FeatureDetector, Features> features) {}

  /**
   * Finds them.
   *
   * @param files the close-up of each object, by the object's name
   */
  public Templates(Map<String, Path> files, List<FeatureDetector> detectors, int threads) {
    List<String> names = List.copyOf(files.keySet());
    List<Known> known = Parallel.map(names, threads, name -> known(files.get(name), detectors));
    for (int i = 0; i < names.size(); i++) {
      objects.put(names.get(i), known.get(i));
    }
  }

  private static Known known(Path file, List<FeatureDetector> detectors) {
    Map<FeatureDetector, Features> features = new EnumMap<>(FeatureDetector.class);
    try (Photograph close = new Photograph(file)) {
      for (FeatureDetector detector : detectors) {
        features.put(
            detector,
            close.lookedAt(detector.word(), () -> detector.extractor().features(close.grey())));
      }
    }
    return new Known(file, features);
  }

  /** Those that a detector finds in an object's template. */
  public Features of(String object, FeatureDetector detector) {
    return objects.get(object).features().get(detector);
  }

  /** A line for each template in which a detector finds nothing. */
  public List<String> warnings() {
    List<String> lines = new ArrayList<>();
    for (Known known : objects.values()) {
      known
          .features()
          .forEach(
              (detector, features) -> {
                if (features.count() == 0) {
                  lines.add(
                      "%s: %s finds no feature in this template, so that its confidence is 0 in every photo, expected a close-up with texture"
                          .formatted(known.file(), detector.word()));
                }
              });
    }
    return lines;
  }

  @Override
  public void close() {
    objects.values().forEach(known -> known.features().values().forEach(Features::close));
  }
}
