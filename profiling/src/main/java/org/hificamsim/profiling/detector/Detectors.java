package org.hificamsim.profiling.detector;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.hificamsim.core.InputException;

/**
 * All detectors, by name: the three of chapter 5 with each {@link MatchReading}, and those that
 * find boxes.
 */
public final class Detectors {
  private static final Map<String, Supplier<FeatureDetector>> FEATURES = features();

  private Detectors() {}

  /** The feature detectors, in the order of the thesis. */
  public static List<String> names() {
    return List.copyOf(FEATURES.keySet());
  }

  /**
   * A new feature detector of this name.
   *
   * @throws InputException when there is none
   */
  public static FeatureDetector create(String name) {
    Supplier<FeatureDetector> maker = FEATURES.get(name);
    if (maker == null) {
      throw new InputException(
          "unknown detector '" + name + "', expected one of " + String.join(", ", names()));
    }
    return maker.get();
  }

  /**
   * The column of a detector as it is asked for, as in {@code orb-located} or {@code hog}.
   *
   * @throws InputException when there is no such detector, or a file it needs
   */
  public static String column(String name) {
    return FEATURES.containsKey(extractor(name)) ? name : BoxSpec.of(name).column();
  }

  /** The feature detectors that these need, each once. */
  public static List<String> extractors(List<String> names) {
    return names.stream()
        .map(Detectors::extractor)
        .filter(FEATURES::containsKey)
        .distinct()
        .toList();
  }

  /** The columns of those that find boxes. */
  public static List<String> boxes(List<String> names) {
    return names.stream()
        .filter(name -> !FEATURES.containsKey(extractor(name)))
        .map(Detectors::column)
        .toList();
  }

  /** New detectors for one thread, which together make the columns of these names. */
  public static List<ConfidenceSource> sources(
      List<String> names, RatioTest test, TemplateFeatures templates) {
    List<ConfidenceSource> sources = new ArrayList<>();
    for (String extractor : extractors(names)) {
      List<MatchReading> readings =
          names.stream()
              .filter(name -> extractor(name).equals(extractor))
              .map(MatchReading::of)
              .toList();
      sources.add(new FeatureSource(create(extractor), readings, test, templates));
    }
    names.stream()
        .filter(name -> !FEATURES.containsKey(extractor(name)))
        .forEach(name -> sources.add(BoxSpec.of(name).create()));
    return sources;
  }

  private static String extractor(String name) {
    return name.substring(0, name.length() - MatchReading.of(name).suffix().length());
  }

  private static Map<String, Supplier<FeatureDetector>> features() {
    Map<String, Supplier<FeatureDetector>> all = new LinkedHashMap<>();
    all.put("orb", OpenCvDetector::orb);
    all.put("sift", OpenCvDetector::sift);
    all.put("surf", SurfDetector::new);
    return all;
  }
}
