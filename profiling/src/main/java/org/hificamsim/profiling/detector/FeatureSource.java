package org.hificamsim.profiling.detector;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.opencv.core.DMatch;

/**
 * Matches an object's template with a photo, and computes one column for each reading of the
 * matches.
 */
final class FeatureSource implements ConfidenceSource {
  private final FeatureDetector detector;
  private final FeatureDetector.Extractor extractor;
  private final List<MatchReading> readings;
  private final RatioTest test;
  private final Templates templates;

  FeatureSource(
      FeatureDetector detector, List<MatchReading> readings, RatioTest test, Templates templates) {
    this.detector = detector;
    this.extractor = detector.extractor();
    this.readings = readings;
    this.test = test;
    this.templates = templates;
  }

  @Override
  public String name() {
    return column(readings.get(0));
  }

  private String column(MatchReading reading) {
    return detector.word() + reading.suffix();
  }

  @Override
  public List<Map<String, Double>> confidences(
      Photograph photo, List<Subject> subjects, boolean shown) {
    List<Map<String, Double>> confidences = new ArrayList<>();
    Map<String, List<DMatch>> matches = new HashMap<>();
    try (Features features = extractor.features(photo.grey())) {
      for (Subject subject : subjects) {
        Features template = templates.features(subject.object(), detector);
        List<DMatch> found =
            matches.computeIfAbsent(subject.object(), object -> test.matches(template, features));
        Map<String, Double> row = new LinkedHashMap<>();
        for (MatchReading reading : readings) {
          row.put(column(reading), reading.confidence(template, features, found, subject.patch()));
        }
        confidences.add(row);
      }
    }
    return confidences;
  }
}
