package org.hificamsim.profiling.detector;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;

/**
 * Finds detectors by name: the three of thesis chapter 5 with each {@link MatchReading}, and
 * networks that find boxes, {@code onnx:FILE}.
 */
public final class Detectors {
  private Detectors() {}

  /** The memory that a network needs for each pixel of a photo. */
  private static final Memory NETWORK_NEED = new Memory(10, 0);

  /** Returns the feature detector of a name; empty for a network. */
  private static Optional<FeatureDetector> features(String name) {
    String word = name.substring(0, name.length() - MatchReading.of(name).suffix().length());
    return Spelling.find(FeatureDetector.class, word);
  }

  private static OnnxDetector.Network network(String name) {
    if (name.startsWith(OnnxDetector.PREFIX)) {
      return OnnxDetector.Network.of(name);
    }
    throw InputException.of(
        "%s has '%s', expected some of orb, sift, surf, each also with -located or -ransac,"
            + " and onnx:FILE",
        setting("detectors"), name);
  }

  private static List<OnnxDetector.Network> networks(List<String> names) {
    return names.stream().filter(name -> features(name).isEmpty()).map(Detectors::network).toList();
  }

  /**
   * Returns the column of a detector in tables, such as {@code orb-located}.
   *
   * @throws InputException if there is no such detector, or its file is missing
   */
  public static String column(String name) {
    return features(name).isPresent() ? name : network(name).column();
  }

  /** Returns the distinct feature detectors among these names. */
  public static List<FeatureDetector> features(List<String> names) {
    return names.stream().flatMap(name -> features(name).stream()).distinct().toList();
  }

  /** Returns the columns of the networks among these names. */
  public static List<String> boxes(List<String> names) {
    return networks(names).stream().map(OnnxDetector.Network::column).toList();
  }

  /** Returns the memory that the most demanding detector needs for each pixel of a photo. */
  public static Memory memoryNeed(List<String> names) {
    Memory none = new Memory(0, 0);
    Memory forFeatures =
        features(names).stream().map(FeatureDetector::need).reduce(none, Memory::max);
    return networks(names).isEmpty() ? forFeatures : forFeatures.max(NETWORK_NEED);
  }

  /** Creates detectors, for one thread, that together compute the columns of these names. */
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
    networks(names).forEach(network -> sources.add(new OnnxDetector(network)));
    return sources;
  }
}
