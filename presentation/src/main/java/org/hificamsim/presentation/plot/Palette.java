package org.hificamsim.presentation.plot;

import java.awt.Color;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.hificamsim.core.Texts;

/**
 * The colours of Okabe and Ito (Color Universal Design, 2008): distinguishable with any common form
 * of colour blindness.
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

  /** What colours mean on every page and in every picture, except lines of policies. */
  public static final Color UNSEEN = VERMILION;

  public static final Color SEEN_ONCE = ORANGE;
  public static final Color SEEN_TWICE = SKY;
  public static final Color SEEN_OFTEN = GREEN;
  public static final Color CAMERA = BLUE;

  /** Levels, the least first: seven of viridis (Smith and van der Walt 2015), from its end. */
  public static final List<Color> LEVELS =
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

  /** The colours for lines, in the order in which they are handed out. */
  public static final List<Color> LINES =
      List.of(BLUE, VERMILION, GREEN, ORANGE, PURPLE, SKY, GREY, YELLOW, BLACK);

  private Palette() {}

  /** The colour of the i-th thing; they come round again after the ninth. */
  public static Color line(int i) {
    return LINES.get(i % LINES.size());
  }

  /** The colours with a meaning for each script of a page: an object, by name. */
  public static String script() {
    return meanings("const MEANING = {%s};\n", "%s: '%s'", ", ");
  }

  /** The same for a style sheet: properties, by name. */
  public static String style() {
    return meanings(":root { %s; }\n", "--%s: %s", "; ");
  }

  private static String meanings(String frame, String one, String between) {
    return frame.formatted(
        MEANINGS.entrySet().stream()
            .map(entry -> one.formatted(entry.getKey(), hex(entry.getValue())))
            .collect(Collectors.joining(between)));
  }

  /** The colour as pages write it. */
  public static String hex(Color color) {
    return Texts.format("#%06x", color.getRGB() & 0xffffff);
  }

  /**
   * The colour as seen through.
   *
   * @param strength 0 for nothing, 1 for the colour itself
   */
  public static Color pale(Color color, double strength) {
    int alpha = (int) Math.round(255 * strength);
    return new Color(color.getRed(), color.getGreen(), color.getBlue(), alpha);
  }
}
