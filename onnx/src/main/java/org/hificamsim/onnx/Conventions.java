package org.hificamsim.onnx;

import java.util.Map;
import org.hificamsim.agents.observation.ObservationLayout;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.worlds.ActionKind;

/**
 * What a trained network was trained with. The file says it in its metadata, under {@code targets},
 * {@code neighbours} and {@code actions}; what is missing there is what environments have by
 * default.
 */
record Conventions(ObservationLayout layout, ActionKind actions) {
  static Conventions of(Map<String, String> metadata) {
    ObservationLayout usual = ObservationLayout.DEFAULT;
    return new Conventions(
        new ObservationLayout(
            number(metadata, "targets", usual.targets()),
            number(metadata, "neighbours", usual.neighbours())),
        Spelling.require(
            ActionKind.class,
            "its metadata actions",
            metadata.getOrDefault("actions", Spelling.of(ActionKind.VIEW))));
  }

  private static int number(Map<String, String> metadata, String key, int otherwise) {
    String text = metadata.get(key);
    try {
      return text == null ? otherwise : Integer.parseInt(text);
    } catch (NumberFormatException e) {
      throw new InputException(
          "its metadata " + key + " is '" + text + "', expected a whole number", e);
    }
  }
}
