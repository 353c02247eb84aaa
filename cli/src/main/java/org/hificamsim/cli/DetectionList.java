package org.hificamsim.cli;

import java.util.Arrays;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.runs.DetectionSpec;

/**
 * A list of detections as users write it. A file whose model bears the name of another model of the
 * list, as a refit of a shipped one does, goes by its file's name.
 */
final class DetectionList {
  private static final int LONGEST = 100;

  private DetectionList() {}

  static List<DetectionSpec> split(String list, Catalogue catalogue) {
    List<String> texts = Arrays.stream(list.split(",", -1)).map(String::strip).toList();
    List<DetectionSpec> plain =
        texts.stream().map(text -> DetectionSpec.parse(text, catalogue::detection)).toList();
    return texts.stream()
        .map(text -> DetectionSpec.parse(text, name -> apart(name, catalogue, plain)))
        .toList();
  }

  private static DetectionModel apart(
      String name, Catalogue catalogue, List<DetectionSpec> others) {
    DetectionModel model = catalogue.detection(name);
    boolean taken =
        others.stream()
            .map(DetectionSpec::model)
            .anyMatch(other -> other.name().equals(model.name()) && !other.equals(model));
    return taken && model instanceof HiFiDetection fitted && !name.equals(model.name())
        ? fitted.named(fileName(name))
        : model;
  }

  /** The end of the file's path, in the letters that a model's name may have. */
  private static String fileName(String path) {
    String legal = path.replaceAll("[^A-Za-z0-9:._-]+", "-");
    return legal
        .substring(Math.max(0, legal.length() - LONGEST))
        .replaceFirst("^[^A-Za-z0-9]+", "");
  }
}
