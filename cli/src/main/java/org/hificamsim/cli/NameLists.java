package org.hificamsim.cli;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.runs.DetectionSpec;

/** Lists of names as users write them. */
final class NameLists {
  private static final int LONGEST_NAME = 100;

  private NameLists() {}

  /**
   * The list {@code P,Q:key=value,key=value,R} of policies, each checked with its options: a part
   * between commas starts a new policy unless it is a {@code key=value} or a number, which
   * continues the one before it.
   *
   * @throws org.hificamsim.core.InputException when one is unknown or there twice, or an option is
   *     wrong
   */
  static List<String> policies(String list, Registry<ZoomPolicy> policies) {
    List<String> specs = new ArrayList<>();
    for (String part : list.split(",", -1)) {
      String text = part.strip();
      boolean continues =
          !specs.isEmpty() && !policies.knows(text) && text.matches("[^:]*=.*|\\d+");
      if (continues) {
        specs.set(specs.size() - 1, specs.get(specs.size() - 1) + "," + text);
      } else {
        specs.add(text);
      }
    }
    specs.forEach(policies::create);
    requireDistinct("--policies", specs);
    return specs;
  }

  /**
   * A list of detections. A file whose model bears the name of another model of the list, as a
   * refit of a shipped one does, goes by its file's name.
   */
  static List<DetectionSpec> detections(String list, Catalogue catalogue) {
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
        .substring(Math.max(0, legal.length() - LONGEST_NAME))
        .replaceFirst("^[^A-Za-z0-9]+", "");
  }

  /**
   * Checks a list.
   *
   * @param what it is, for the message
   * @throws InputException when a name is there twice
   */
  static void requireDistinct(String what, List<String> names) {
    for (int i = 0; i < names.size(); i++) {
      if (names.indexOf(names.get(i)) < i) {
        throw new InputException(what + " has '" + names.get(i) + "' twice, expected each once");
      }
    }
  }
}
