package org.hificamsim.tracks.place;

import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Reads heights as OpenStreetMap has them: {@code 12}, {@code 12 m}, {@code 2,5}, {@code 39.4 ft},
 * {@code 39'4"}.
 */
final class HeightText {
  private static final Pattern METRIC =
      Pattern.compile(
          "([+-]?[0-9]+,[0-9]{1,2}|[+-]?[0-9]*\\.?[0-9]+(?:[eE][+-]?[0-9]+)?)"
              + "\\s*(m|metres?|meters?|cm|ft|feet)?");
  private static final Pattern FEET =
      Pattern.compile("([0-9]+(?:\\.[0-9]+)?)\\s*'\\s*(?:([0-9]+(?:\\.[0-9]+)?)\\s*\")?");
  private static final int MAX_LENGTH = 40;
  private static final double METRES_PER_FOOT = 0.3048;
  private static final double METRES_PER_INCH = 0.0254;

  private HeightText() {}

  /** Returns the height in metres; empty if the text is none. */
  static OptionalDouble metres(String text) {
    if (text.length() > MAX_LENGTH) {
      return OptionalDouble.empty();
    }
    Matcher metric = METRIC.matcher(text.strip());
    if (metric.matches()) {
      return OptionalDouble.of(
          Double.parseDouble(metric.group(1).replace(',', '.')) * unit(metric.group(2)));
    }
    Matcher feet = FEET.matcher(text.strip());
    if (feet.matches()) {
      double inches = feet.group(2) == null ? 0 : Double.parseDouble(feet.group(2));
      return OptionalDouble.of(
          Double.parseDouble(feet.group(1)) * METRES_PER_FOOT + inches * METRES_PER_INCH);
    }
    return OptionalDouble.empty();
  }

  private static double unit(String unit) {
    return unit == null || unit.startsWith("m") ? 1 : unit.equals("cm") ? 0.01 : METRES_PER_FOOT;
  }
}
