package org.hificamsim.tracks.place;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads lengths with their units as CSS and SVG define them (96 px are an inch). */
final class SvgLength {
  private static final Pattern LENGTH =
      Pattern.compile("([+-]?(?:\\d++(?:\\.\\d*+)?|\\.\\d++)(?:[eE][+-]?\\d++)?)\\s*(%|[a-zA-Z]*)");
  private static final double PIXELS_PER_INCH = 96;
  private static final double PIXELS_PER_CM = PIXELS_PER_INCH / 2.54;
  private static final double USUAL_FONT_SIZE = 16;

  private SvgLength() {}

  /**
   * Returns a length in pixels, which are units of the drawing.
   *
   * @param fullLength the length of 100 %; NaN if it is not known
   * @return NaN if the text is no length
   */
  static double pixels(String text, double fullLength) {
    Matcher matcher = LENGTH.matcher(text.strip());
    return matcher.matches()
        ? Double.parseDouble(matcher.group(1)) * unit(matcher.group(2), fullLength)
        : Double.NaN;
  }

  private static double unit(String unit, double fullLength) {
    return switch (unit.toLowerCase(Locale.ROOT)) {
      case "", "px" -> 1;
      case "%" -> fullLength / 100;
      case "in" -> PIXELS_PER_INCH;
      case "cm" -> PIXELS_PER_CM;
      case "mm" -> PIXELS_PER_CM / 10;
      case "q" -> PIXELS_PER_CM / 40;
      case "pt" -> PIXELS_PER_INCH / 72;
      case "pc" -> PIXELS_PER_INCH / 6;
      case "em", "rem" -> USUAL_FONT_SIZE;
      case "ex", "ch" -> USUAL_FONT_SIZE / 2;
      default -> Double.NaN;
    };
  }

  /** Whether a length has a unit of paper, so that the size of the drawing on paper is known. */
  static boolean isPhysical(String text) {
    return text.strip().toLowerCase(Locale.ROOT).matches(".*\\d\\s*(in|cm|mm|q|pt|pc)");
  }
}
