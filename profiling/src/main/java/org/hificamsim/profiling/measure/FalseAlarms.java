package org.hificamsim.profiling.measure;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.dataset.LabelledPhoto;
import org.hificamsim.profiling.detector.ConfidenceSource.Subject;

/**
 * What the detectors make of photos without any of the objects. Each photo is asked for each
 * object, at places and in sizes that the object has in the other photos.
 */
record FalseAlarms(Dataset dataset, DetectorPool detectors) {
  private static final int PLACES = 8;

  /** Every confidence of every photo, object and place, by detector. */
  Map<String, List<Double>> confidences(int threads, MeasureProgress watcher) {
    List<Subject> subjects = subjects();
    Map<String, List<Double>> all = new LinkedHashMap<>();
    Parallel.map(
            dataset.negatives(),
            threads,
            photo -> {
              List<Map<String, Double>> seen = detectors.confidences(photo, subjects, false);
              watcher.advance();
              return seen;
            })
        .stream()
        .flatMap(List::stream)
        .forEach(
            row ->
                row.forEach(
                    (detector, value) ->
                        all.computeIfAbsent(detector, d -> new ArrayList<>()).add(value)));
    return all;
  }

  /** How many photos and objects were looked at; places in one photo are not independent. */
  int looks() {
    return dataset.negatives().size() * dataset.templates().size();
  }

  private List<Subject> subjects() {
    List<Subject> subjects = new ArrayList<>();
    for (String object : dataset.templates().keySet()) {
      List<LabelledPhoto> of =
          dataset.samples().stream().filter(s -> s.object().equals(object)).toList();
      int places = Math.min(PLACES, of.size());
      for (int i = 0; i < places; i++) {
        subjects.add(new Subject(object, of.get(i * of.size() / places).patch()));
      }
    }
    return subjects;
  }
}
