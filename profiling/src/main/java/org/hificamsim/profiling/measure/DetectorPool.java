package org.hificamsim.profiling.measure;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.hificamsim.profiling.detector.ConfidenceSource;
import org.hificamsim.profiling.detector.ConfidenceSource.Subject;
import org.hificamsim.profiling.detector.Detectors;
import org.hificamsim.profiling.detector.Photograph;
import org.hificamsim.profiling.detector.Templates;

/** Looks at photos with all detectors; each set of them is used by one thread at a time. */
final class DetectorPool {
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
   * @param shown whether the photo has the subjects
   * @return the confidences of each subject, by column
   */
  List<Map<String, Double>> confidences(Path file, List<Subject> subjects, boolean shown) {
    List<Map<String, Double>> all =
        subjects.stream().<Map<String, Double>>map(subject -> new LinkedHashMap<>()).toList();
    List<ConfidenceSource> kept = free.poll();
    List<ConfidenceSource> detectors = kept != null ? kept : detectors();
    try (Photograph photo = new Photograph(file)) {
      for (ConfidenceSource detector : detectors) {
        List<Map<String, Double>> found =
            photo.lookedAt(detector.name(), () -> detector.confidences(photo, subjects, shown));
        for (int i = 0; i < all.size(); i++) {
          all.get(i).putAll(found.get(i));
        }
      }
      return all;
    } finally {
      free.add(detectors);
    }
  }
}
