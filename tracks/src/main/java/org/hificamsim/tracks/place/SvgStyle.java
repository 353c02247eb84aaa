package org.hificamsim.tracks.place;

import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * The properties that decide whether and in which colours an element is drawn.
 *
 * @param visible whether {@code visibility} shows the element
 * @param opaque whether the element and all around it have an opacity above 0
 * @param fill fill colour of areas; "none" if there is none
 * @param stroke colour of lines; empty if it is not given
 */
record SvgStyle(boolean visible, boolean opaque, String fill, String stroke) {
  /** The style of the root before its own properties. */
  static final SvgStyle INITIAL = new SvgStyle(true, true, "#000000", "");

  /** The properties that may be attributes. */
  static final List<String> PROPERTIES =
      List.of("display", "visibility", "opacity", "fill", "stroke");

  private static final String NONE = "none";

  /** Returns the style of an element with its own values of properties. */
  SvgStyle with(Map<String, String> values) {
    String visibility = values.getOrDefault("visibility", "inherit");
    return new SvgStyle(
        isInherited(visibility) ? visible : visibility.equals("visible"),
        opaque && SvgLength.pixels(values.getOrDefault("opacity", "1"), 1) != 0,
        colour(values.get("fill"), fill),
        colour(values.get("stroke"), stroke));
  }

  private static boolean isInherited(String value) {
    return value.equals("inherit") || value.equals("unset");
  }

  private static String colour(String value, String inherited) {
    if (value == null || isInherited(value)) {
      return inherited;
    }
    String text = value.toLowerCase(Locale.ROOT).replaceAll("\\s+", "");
    if (text.matches("#[0-9a-f]{3}")) {
      return text.replaceAll("([0-9a-f])", "$1$1");
    }
    return text.equals("transparent")
        ? NONE
        : text.matches("rgb\\(\\d+,\\d+,\\d+\\)") ? hex(text) : text;
  }

  private static String hex(String rgb) {
    String[] parts = rgb.substring("rgb(".length(), rgb.length() - 1).split(",");
    StringBuilder hex = new StringBuilder("#");
    for (String part : parts) {
      int value = part.length() > 3 ? 255 : Math.min(255, Integer.parseInt(part));
      hex.append(String.format(Locale.ROOT, "%02x", value));
    }
    return hex.toString();
  }

  boolean isFilled() {
    return !fill.equals(NONE);
  }

  private boolean isStroked() {
    return !stroke.equals(NONE);
  }

  /**
   * Whether a shape is drawn. A line without a given stroke counts as drawn, although SVG does not
   * draw it.
   *
   * @param isLine whether the shape has no inside
   */
  boolean draws(boolean isLine) {
    boolean painted = isLine ? isStroked() : isFilled() || (isStroked() && !stroke.isEmpty());
    return visible && opaque && painted;
  }

  /** The colours that a shape is drawn in. */
  List<String> colours(boolean isLine) {
    return List.of(isLine ? NONE : fill, stroke).stream()
        .filter(colour -> !colour.isEmpty() && !colour.equals(NONE))
        .distinct()
        .toList();
  }
}
