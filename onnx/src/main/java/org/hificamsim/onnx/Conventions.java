package org.hificamsim.onnx;

import ai.onnxruntime.NodeInfo;
import ai.onnxruntime.TensorInfo;
import java.util.Map;
import org.hificamsim.agents.observation.ObservationLayout;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.worlds.ActionKind;

/**
 * The observations and actions that a network was trained with. They are in the metadata of the
 * file as {@code targets}, {@code neighbours}, {@code belief} and {@code actions}; missing entries
 * have the defaults of the environments. The width of the input says whether observations contain
 * heights. An input of cameras x views x numbers is the belief alone, on any site.
 *
 * @param belief whether observations end with what each view promises
 * @param seesViewsAlone whether the network's input is what each view promises, and nothing else
 */
record Conventions(
    ObservationLayout layout, boolean belief, boolean seesViewsAlone, ActionKind actions) {
  static Conventions of(Map<String, String> metadata, NodeInfo input) {
    ObservationLayout defaults = ObservationLayout.DEFAULT;
    int targets = number(metadata, "targets", defaults.targets());
    int neighbours = number(metadata, "neighbours", defaults.neighbours());
    boolean views = rank(input) == 3;
    boolean belief = views || isTrue(metadata, "belief");
    return new Conventions(
        new ObservationLayout(targets, neighbours, false),
        belief,
        views,
        Spelling.require(
            ActionKind.class,
            "its metadata actions",
            metadata.getOrDefault("actions", Spelling.of(ActionKind.VIEW))));
  }

  /**
   * Returns the layout of observations for a network of cameras.
   *
   * @param width the width of the input; negative if it is open
   */
  ObservationLayout layout(NetworkView network, long width) {
    ObservationLayout flat = belief ? layout.withBelief(network) : layout;
    ObservationLayout high =
        new ObservationLayout(layout.targets(), layout.neighbours(), true, flat.views());
    return high.size() == width ? high : flat;
  }

  private static int rank(NodeInfo input) {
    return input.getInfo() instanceof TensorInfo tensor ? tensor.getShape().length : 0;
  }

  private static boolean isTrue(Map<String, String> metadata, String key) {
    String text = metadata.getOrDefault(key, "false");
    if (!text.equals("true") && !text.equals("false")) {
      throw InputException.of("its metadata %s is '%s', expected true or false", key, text);
    }
    return text.equals("true");
  }

  private static int number(Map<String, String> metadata, String key, int defaultValue) {
    String text = metadata.get(key);
    try {
      return text == null ? defaultValue : Integer.parseInt(text);
    } catch (NumberFormatException e) {
      throw new InputException(
          "its metadata " + key + " is '" + text + "', expected a whole number", e);
    }
  }
}
