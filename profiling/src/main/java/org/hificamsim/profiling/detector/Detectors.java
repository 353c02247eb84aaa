package org.hificamsim.profiling.detector;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.hificamsim.core.InputException;

/** The three detectors of chapter 5, by name. */
public final class Detectors {
  private static final Map<String, Supplier<FeatureDetector>> ALL = all();

  private Detectors() {}

  /** All names, in the order of the thesis. */
  public static List<String> names() {
    return List.copyOf(ALL.keySet());
  }

  /**
   * A new detector of this name.
   *
   * @throws InputException when there is none
   */
  public static FeatureDetector create(String name) {
    Supplier<FeatureDetector> maker = ALL.get(name);
    if (maker == null) {
      throw new InputException(
          "unknown detector '" + name + "', expected one of " + String.join(", ", names()));
    }
    return maker.get();
  }

  private static Map<String, Supplier<FeatureDetector>> all() {
    Map<String, Supplier<FeatureDetector>> all = new LinkedHashMap<>();
    all.put("orb", OpenCvDetector::orb);
    all.put("sift", OpenCvDetector::sift);
    all.put("surf", SurfDetector::new);
    return all;
  }
}
