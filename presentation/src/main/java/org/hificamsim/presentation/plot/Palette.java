package org.hificamsim.presentation.plot;

import java.awt.Color;
import java.util.List;

/**
 * The colours of Okabe and Ito (Color Universal Design, 2008): told apart by people with any common
 * form of colour blindness.
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

  /** The colours for lines, in the order in which they are handed out. */
  public static final List<Color> LINES =
      List.of(BLUE, VERMILION, GREEN, ORANGE, PURPLE, SKY, GREY, YELLOW, BLACK);

  /** Of a scale, dark to light: viridis, which people with colour blindness read alike. */
  private static final int[] SCALE = {0x440154, 0x3B528B, 0x21918C, 0x5EC962, 0xFDE725};

  private Palette() {}

  /**
   * A colour of a scale.
   *
   * @param share 0 for the least, dark, and 1 for the most, light
   */
  public static Color scale(double share) {
    double at = Math.max(0, Math.min(1, share)) * (SCALE.length - 1);
    int low = Math.min((int) at, SCALE.length - 2);
    int rgb = 0;
    for (int shift : new int[] {16, 8, 0}) {
      int from = SCALE[low] >> shift & 255;
      int to = SCALE[low + 1] >> shift & 255;
      rgb |= (int) Math.round(from + (at - low) * (to - from)) << shift;
    }
    return new Color(rgb);
  }

  /** The colour of the i-th thing; they come round again after the ninth. */
  public static Color line(int i) {
    return LINES.get(i % LINES.size());
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
