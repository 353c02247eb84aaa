package org.hificamsim.profiling.measure;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import org.hificamsim.profiling.detector.ConfidenceSource;
import org.hificamsim.profiling.detector.ConfidenceSource.Look;
import org.hificamsim.profiling.detector.Photograph;

/** Looks at one photo with all detectors, one after the other. */
record Gaze(Toolboxes toolboxes) {
  /**
   * Confidences by column, for each subject.
   *
   * @param asked what is asked of a detector's look, for each subject
   */
  <S> List<Map<String, Double>> at(
      Path file, List<S> subjects, BiFunction<Look, S, double[]> asked) {
    List<Map<String, Double>> all =
        subjects.stream().<Map<String, Double>>map(subject -> new LinkedHashMap<>()).toList();
    try (Photograph photo = new Photograph(file)) {
      toolboxes.use(
          sources -> {
            sources.forEach(source -> add(source, photo, subjects, asked, all));
            return all;
          });
    }
    return all;
  }

  private static <S> void add(
      ConfidenceSource source,
      Photograph photo,
      List<S> subjects,
      BiFunction<Look, S, double[]> asked,
      List<Map<String, Double>> all) {
    List<String> columns = source.columns();
    Failures.named(
        photo.file(),
        columns.get(0),
        () -> {
          try (Look look = source.look(photo)) {
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
}
