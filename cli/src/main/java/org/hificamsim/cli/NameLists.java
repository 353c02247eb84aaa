package org.hificamsim.cli;

import java.util.Arrays;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.hifi.FittedDetection;
import org.hificamsim.runs.DetectionSpec;

/** Reads lists of names that users write. */
final class NameLists {
  private static final int MAX_LENGTH = 100;

  private NameLists() {}

  /**
   * Reads a list of policies, and checks each with its options.
   *
   * @throws org.hificamsim.core.InputException when a policy is unknown or occurs twice, or an
   *     option is wrong
   */
  static List<String> policies(String list, Registry<ZoomPolicy> policies) {
    List<String> specs = Options.splitNames(list, policies::knows);
    specs.forEach(policies::create);
    requireDistinct("--policies", specs);
    return specs;
  }

  /**
   * Reads a list of detections. If a model in a file has the same name as another model of the
   * list, such as a shipped one that was fitted again, it gets the name of its file.
   */
  static List<DetectionSpec> detections(String list, Catalogue catalogue) {
    List<String> texts = Arrays.stream(list.split(",", -1)).map(String::strip).toList();
    List<DetectionSpec> specs =
        texts.stream().map(text -> DetectionSpec.parse(text, catalogue::detection)).toList();
    return texts.stream()
        .map(text -> DetectionSpec.parse(text, name -> distinctModel(name, catalogue, specs)))
        .toList();
  }

  private static DetectionModel distinctModel(
      String name, Catalogue catalogue, List<DetectionSpec> others) {
    DetectionModel model = catalogue.detection(name);
    boolean isTaken =
        others.stream()
            .map(DetectionSpec::model)
            .anyMatch(other -> other.name().equals(model.name()) && !other.equals(model));
    return isTaken && model instanceof FittedDetection fitted && !name.equals(model.name())
        ? fitted.named(fileName(name))
        : model;
  }

  /** Shortens a file's path to its end, with the characters that a model's name may have. */
  private static String fileName(String path) {
    String legal = path.replaceAll("[^A-Za-z0-9:._-]+", "-");
    return legal
        .substring(Math.max(0, legal.length() - MAX_LENGTH))
        .replaceFirst("^[^A-Za-z0-9]+", "");
  }

  /**
   * Checks that no name occurs twice.
   *
   * @param list the name of the list, for the message
   * @throws InputException when a name occurs twice
   */
  static void requireDistinct(String list, List<String> names) {
    for (int i = 0; i < names.size(); i++) {
      if (names.indexOf(names.get(i)) < i) {
        throw new InputException(list + " has '" + names.get(i) + "' twice, expected each once");
      }
    }
  }
}
