package org.hificamsim.profiling.detector;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.profiling.dataset.Patch;
import org.opencv.core.DMatch;

/**
 * A feature detector at work: it matches the objects' templates with photos, and makes a column of
 * confidences for each reading of the matches. An instance serves one thread.
 */
public final class FeatureSource {
  private final FeatureDetector detector;
  private final FeatureDetector.Extractor extractor;
  private final List<MatchReading> readings;
  private final RatioTest test;
  private final Templates templates;

  private FeatureSource(
      FeatureDetector detector, List<MatchReading> readings, RatioTest test, Templates templates) {
    this.detector = detector;
    this.extractor = detector.extractor();
    this.readings = readings;
    this.test = test;
    this.templates = templates;
  }

  /**
   * What a detector is asked for in a photo.
   *
   * @param object by its name
   * @param patch where it is, or where it would be
   */
  public record Subject(String object, Patch patch) {}

  /** New detectors for one thread, which together make the columns of these names. */
  public static List<FeatureSource> all(List<String> names, RatioTest test, Templates templates) {
    return FeatureDetector.all(names).stream()
        .map(
            detector ->
                new FeatureSource(
                    detector,
                    names.stream()
                        .filter(name -> FeatureDetector.of(name) == detector)
                        .map(MatchReading::of)
                        .toList(),
                    test,
                    templates))
        .toList();
  }

  /** What it is called when it fails: the name of its first column. */
  public String name() {
    return column(readings.get(0));
  }

  private String column(MatchReading reading) {
    return detector.word() + reading.suffix();
  }

  /**
   * Looks at a photo once, for some subjects.
   *
   * @return the confidences of each subject, by column; each in [0, 1]
   */
  public List<Map<String, Double>> confidences(Photograph photo, List<Subject> subjects) {
    List<Map<String, Double>> all = new ArrayList<>();
    Map<String, List<DMatch>> matches = new HashMap<>();
    try (Features features = extractor.features(photo.grey())) {
      for (Subject subject : subjects) {
        Features template = templates.of(subject.object(), detector);
        List<DMatch> found =
            matches.computeIfAbsent(subject.object(), object -> test.matches(template, features));
        Map<String, Double> row = new LinkedHashMap<>();
        for (MatchReading reading : readings) {
          row.put(column(reading), reading.confidence(template, features, found, subject.patch()));
        }
        all.add(row);
      }
    }
    return all;
  }
}
