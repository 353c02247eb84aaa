package org.hificamsim.profiling.measure;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.detector.Detectors;
import org.hificamsim.profiling.detector.FeatureDetector;
import org.hificamsim.profiling.detector.Features;
import org.hificamsim.profiling.detector.Photograph;
import org.hificamsim.profiling.detector.TemplateFeatures;

/** The features of each object, from its close-up. */
final class Templates implements TemplateFeatures, AutoCloseable {
  private final Map<String, Known> objects = new LinkedHashMap<>();

  private record Known(Path file, Map<String, Features> features) {}

  private Templates() {}

  /** Those of a data set, for some feature detectors. */
  static Templates of(Dataset dataset, List<String> extractors, int threads) {
    List<String> names = List.copyOf(dataset.templates().keySet());
    List<Known> known =
        Parallel.map(names, threads, name -> known(dataset.templates().get(name), extractors));
    Templates templates = new Templates();
    for (int i = 0; i < names.size(); i++) {
      templates.objects.put(names.get(i), known.get(i));
    }
    return templates;
  }

  @Override
  public Features of(String object, String detector) {
    return objects.get(object).features().get(detector);
  }

  /** A line for each template in which a detector finds nothing. */
  List<String> warnings() {
    List<String> lines = new ArrayList<>();
    for (Known known : objects.values()) {
      known
          .features()
          .forEach(
              (detector, features) -> {
                if (features.count() == 0) {
                  lines.add(
                      "%s: %s finds no feature in this template, so that its confidence is 0 in every photo, expected a close-up with texture"
                          .formatted(known.file(), detector));
                }
              });
    }
    return lines;
  }

  private static Known known(Path file, List<String> extractors) {
    Map<String, Features> features = new LinkedHashMap<>();
    try (Photograph close = new Photograph(file)) {
      for (String extractor : extractors) {
        try (FeatureDetector detector = Detectors.create(extractor)) {
          features.put(
              extractor, Failures.named(file, extractor, () -> detector.detect(close.grey())));
        }
      }
      return new Known(file, features);
    }
  }

  @Override
  public void close() {
    objects.values().forEach(known -> known.features().values().forEach(Features::close));
  }
}
