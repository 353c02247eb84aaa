package org.hificamsim.tracks.place;

import java.util.Locale;
import java.util.Set;

/**
 * A name by which parts of a drawing can be chosen.
 *
 * @param kind the kind of the name, such as "layer"
 */
record Label(String kind, String name) {
  private static final Set<String> COLOURS = Set.of("color", "colour", "stroke", "fill");
  private static final Set<String> KINDS = Set.of("layer", "class", "id");

  static final String LAYER = "layer";
  static final String CLASS = "class";
  static final String COLOUR = "colour";
  static final String GROUP = "id of a group";
  static final String BLOCK = "block";
  static final String PROPERTY = "property";

  /** The id of a single shape; lists of labels leave it out. */
  static final String ID = "id";

  /** The label that a property of a feature, or a column of a table, gives. */
  static Label ofProperty(String name, String value) {
    String kind = name.toLowerCase(Locale.ROOT);
    if (KINDS.contains(kind)) {
      return new Label(kind, value);
    }
    return COLOURS.contains(kind)
        ? new Label(COLOUR, value)
        : new Label(PROPERTY, name + "=" + value);
  }
}
