package org.hificamsim.profiling.measure;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.BiFunction;
import org.hificamsim.profiling.detector.ConfidenceSource;
import org.hificamsim.profiling.detector.ConfidenceSource.Look;
import org.hificamsim.profiling.detector.Detectors;
import org.hificamsim.profiling.detector.Photograph;

/** Looks at photos with all detectors; each set of them is used by one thread at a time. */
final class DetectorPool implements AutoCloseable {
  private final MeasureSettings settings;
  private final Templates templates;
  private final ConcurrentLinkedQueue<List<ConfidenceSource>> free = new ConcurrentLinkedQueue<>();

  DetectorPool(MeasureSettings settings, Templates templates) {
    this.settings = settings;
    this.templates = templates;
    free.add(detectors()); // a file that is no detector's is refused at once
  }

  private List<ConfidenceSource> detectors() {
    return Detectors.sources(settings.detectors(), settings.test(), templates);
  }

  /**
   * Looks at a photo with one detector after the other.
   *
   * @param asked what a detector that has looked at the photo is asked about each subject
   * @return the confidences of each subject, by column
   */
  <S> List<Map<String, Double>> confidences(
      Path file, List<S> subjects, BiFunction<Look, S, double[]> asked) {
    List<Map<String, Double>> all =
        subjects.stream().<Map<String, Double>>map(subject -> new LinkedHashMap<>()).toList();
    List<ConfidenceSource> kept = free.poll();
    List<ConfidenceSource> detectors = kept != null ? kept : detectors();
    try (Photograph photo = new Photograph(file)) {
      detectors.forEach(detector -> add(detector, photo, subjects, asked, all));
      return all;
    } finally {
      free.add(detectors);
    }
  }

  private static <S> void add(
      ConfidenceSource detector,
      Photograph photo,
      List<S> subjects,
      BiFunction<Look, S, double[]> asked,
      List<Map<String, Double>> all) {
    List<String> columns = detector.columns();
    Failures.named(
        photo.file(),
        columns.get(0),
        () -> {
          try (Look look = detector.look(photo)) {
            for (int i = 0; i < subjects.size(); i++) {
              double[] values = asked.apply(look, subjects.get(i));
              for (int j = 0; j < values.length; j++) {
                all.get(i).put(columns.get(j), values[j]);
              }
            }
          }
          return all;
        });
  }

  @Override
  public void close() {
    free.forEach(detectors -> detectors.forEach(ConfidenceSource::close));
  }
}
