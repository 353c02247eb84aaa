package org.hificamsim.profiling.detector;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;

/**
 * All detectors, by name: the three of chapter 5 with each {@link MatchReading}, and those that
 * find boxes, {@code hog} and {@code onnx:FILE}.
 */
public final class Detectors {
  private Detectors() {}

  /**
   * A detector of boxes as it is asked for.
   *
   * @param column its name in tables
   * @param need the memory that it takes for each pixel
   * @param maker makes a new one
   */
  private record BoxSpec(String column, Memory need, Supplier<BoxDetector> maker) {
    static BoxSpec of(String name) {
      if (name.equals("hog")) {
        return new BoxSpec(name, new Memory(60, 0), PeopleDetector::new);
      }
      if (name.startsWith(OnnxDetector.PREFIX)) {
        OnnxDetector.Network network = OnnxDetector.Network.of(name);
        return new BoxSpec(network.column(), new Memory(10, 0), () -> new OnnxDetector(network));
      }
      throw InputException.of(
          "%s has '%s', expected some of orb, sift, surf, each also with -located or"
              + " -ransac, hog, onnx:FILE",
          setting("detectors"), name);
    }
  }

  /** The feature detector that a name asks for; none where it asks for boxes. */
  private static Optional<FeatureDetector> features(String name) {
    String word = name.substring(0, name.length() - MatchReading.of(name).suffix().length());
    return Spelling.find(FeatureDetector.class, word);
  }

  private static List<BoxSpec> boxSpecs(List<String> names) {
    return names.stream().filter(name -> features(name).isEmpty()).map(BoxSpec::of).toList();
  }

  /**
   * The column of a detector as it is asked for, as in {@code orb-located} or {@code hog}.
   *
   * @throws InputException when there is no such detector, or a file it needs
   */
  public static String column(String name) {
    return features(name).isPresent() ? name : BoxSpec.of(name).column();
  }

  /** The feature detectors that these need, each once. */
  public static List<FeatureDetector> features(List<String> names) {
    return names.stream().flatMap(name -> features(name).stream()).distinct().toList();
  }

  /** The columns of those that find boxes. */
  public static List<String> boxes(List<String> names) {
    return boxSpecs(names).stream().map(BoxSpec::column).toList();
  }

  /** What the one with the largest need takes for each pixel of a photo. */
  public static Memory memoryNeed(List<String> names) {
    Memory none = new Memory(0, 0);
    Memory forFeatures =
        features(names).stream().map(FeatureDetector::need).reduce(none, Memory::max);
    return boxSpecs(names).stream().map(BoxSpec::need).reduce(forFeatures, Memory::max);
  }

  /** New detectors for one thread, which together make the columns of these names. */
  public static List<ConfidenceSource> sources(
      List<String> names, RatioTest test, Templates templates) {
    List<ConfidenceSource> sources = new ArrayList<>();
    for (FeatureDetector detector : features(names)) {
      List<MatchReading> readings =
          names.stream()
              .filter(name -> features(name).filter(detector::equals).isPresent())
              .map(MatchReading::of)
              .toList();
      sources.add(new FeatureSource(detector, readings, test, templates));
    }
    boxSpecs(names).forEach(spec -> sources.add(spec.maker().get()));
    return sources;
  }
}
