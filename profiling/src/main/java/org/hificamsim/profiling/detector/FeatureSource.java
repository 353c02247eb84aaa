package org.hificamsim.profiling.detector;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.opencv.core.DMatch;

/** Matches an object's template with a photo: one column for each reading of the matches. */
final class FeatureSource implements ConfidenceSource {
  private final FeatureDetector detector;
  private final List<MatchReading> readings;
  private final RatioTest test;
  private final TemplateFeatures templates;

  FeatureSource(
      FeatureDetector detector,
      List<MatchReading> readings,
      RatioTest test,
      TemplateFeatures templates) {
    this.detector = detector;
    this.readings = List.copyOf(readings);
    this.test = test;
    this.templates = templates;
  }

  @Override
  public List<String> columns() {
    UnaryOperator<String> named = suffix -> detector.name() + suffix;
    return readings.stream().map(MatchReading::suffix).map(named).toList();
  }

  @Override
  public Look look(Photograph photo) {
    return new Matched(detector.detect(photo.grey()));
  }

  @Override
  public void close() {
    detector.close();
  }

  /** A photo's features, and their matches with the objects that were asked for. */
  private final class Matched implements Look {
    private final Features features;
    private final Map<String, List<DMatch>> matches = new HashMap<>();

    Matched(Features features) {
      this.features = features;
    }

    @Override
    public double[] confidences(Subject subject) {
      Features template = templates.of(subject.object(), detector.name());
      List<DMatch> found =
          matches.computeIfAbsent(subject.object(), object -> test.matches(template, features));
      return readings.stream()
          .mapToDouble(r -> r.confidence(template, features, found, subject.patch()))
          .toArray();
    }

    @Override
    public void close() {
      features.close();
    }
  }
}
