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
  private static final Map<String, Extractor> FEATURES = features();

  /** How a feature detector is made, and the memory that it takes. */
  private record Extractor(Supplier<FeatureDetector> maker, MemoryNeed need) {}

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
    Extractor extractor = FEATURES.get(name);
    if (extractor == null) {
      throw new InputException(
          "unknown detector '" + name + "', expected one of " + String.join(", ", names()));
    }
    return extractor.maker().get();
  }

  /**
   * The column of a detector as it is asked for, as in {@code orb-located} or {@code hog}.
   *
   * @throws InputException when there is no such detector, or a file it needs
   */
  public static String column(String name) {
    return FEATURES.containsKey(extractor(name)) ? name : BoxSpec.of(name).column();
  }

  /** The memory that the one with the largest need takes. */
  public static MemoryNeed memoryNeed(List<String> names) {
    return names.stream()
        .map(
            name ->
                FEATURES.containsKey(extractor(name))
                    ? FEATURES.get(extractor(name)).need()
                    : BoxSpec.of(name).need())
        .reduce(new MemoryNeed(0, 0), MemoryNeed::max);
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

  private static Map<String, Extractor> features() {
    Map<String, Extractor> all = new LinkedHashMap<>();
    all.put("orb", new Extractor(OpenCvDetector::orb, new MemoryNeed(20, 0)));
    // Both pyramids of a picture that is enlarged twice, in 32 bits.
    all.put("sift", new Extractor(OpenCvDetector::sift, new MemoryNeed(250, 0)));
    all.put("surf", new Extractor(SurfDetector::new, new MemoryNeed(2, 50)));
    return all;
  }
}
