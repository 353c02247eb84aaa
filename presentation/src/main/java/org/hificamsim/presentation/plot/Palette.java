package org.hificamsim.presentation.plot;

import java.awt.Color;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.hificamsim.core.Texts;

/**
 * The colours of Okabe and Ito (Color Universal Design, 2008), which people with any common form of
 * colour blindness can tell apart.
 */
public final class Palette {
  public static final Color BLACK = new Color(0x222222);
  public static final Color ORANGE = new Color(0xE69F00);
  public static final Color SKY = new Color(0x56B4E9);
  public static final Color GREEN = new Color(0x009E73);
  public static final Color YELLOW = new Color(0xF0E442);
  public static final Color BLUE = new Color(0x0072B2);
  public static final Color VERMILION = new Color(0xD55E00);
  public static final Color PURPLE = new Color(0xCC79A7);
  public static final Color GREY = new Color(0x8A8A8A);
  private static final Color BROWN = new Color(0x8B4513);
  private static final Color INDIGO = new Color(0x5B3FA0);
  private static final Color OLIVE = new Color(0x8A8A00);
  private static final Color WINE = new Color(0x882255);
  private static final Color TEAL = new Color(0x2F7F86);

  // the meanings of colours on all pages and pictures, except for lines of policies

  public static final Color UNSEEN = VERMILION;

  public static final Color SEEN_ONCE = ORANGE;
  public static final Color SEEN_TWICE = SKY;
  public static final Color SEEN_OFTEN = GREEN;
  public static final Color CAMERA = BLUE;

  /**
   * The colours of ordered classes, the least first, from viridis (Smith and van der Walt 2015).
   */
  public static final List<Color> SEQUENCE =
      IntStream.of(0xFDE725, 0x90D743, 0x35B779, 0x21918C, 0x31688E, 0x443983, 0x440154)
          .mapToObj(Color::new)
          .toList();

  private static final Map<String, Color> MEANINGS =
      new TreeMap<>(
          Map.of(
              "unseen", UNSEEN,
              "once", SEEN_ONCE,
              "twice", SEEN_TWICE,
              "often", SEEN_OFTEN,
              "cameras", CAMERA));

  /** The colours of lines, in the order in which they are assigned; all can be seen on white. */
  public static final List<Color> LINES =
      List.of(BLUE, VERMILION, GREEN, ORANGE, PURPLE, SKY, BROWN, INDIGO, OLIVE, WINE, GREY, TEAL);

  private Palette() {}

  /** Returns the colour of the i-th line; colours repeat after the twelfth. */
  public static Color line(int i) {
    return LINES.get(i % LINES.size());
  }

  /** Returns a line of script that defines the colours with a meaning, by name. */
  public static String script() {
    return meanings("const MEANING = {%s};\n", "%s: '%s'", ", ");
  }

  /** Returns a rule of a style sheet that defines the colours with a meaning, by name. */
  public static String style() {
    return meanings(":root { %s; }\n", "--%s: %s", "; ");
  }

  private static String meanings(String frame, String entryFormat, String separator) {
    return frame.formatted(
        MEANINGS.entrySet().stream()
            .map(entry -> entryFormat.formatted(entry.getKey(), hex(entry.getValue())))
            .collect(Collectors.joining(separator)));
  }

  /** Returns a colour in the form {@code #rrggbb}. */
  public static String hex(Color color) {
    return Texts.format("#%06x", color.getRGB() & 0xffffff);
  }

  /**
   * Returns a transparent colour.
   *
   * @param strength the opacity, from 0 to 1
   */
  public static Color pale(Color color, double strength) {
    int alpha = (int) Math.round(255 * strength);
    return new Color(color.getRed(), color.getGreen(), color.getBlue(), alpha);
  }
}
