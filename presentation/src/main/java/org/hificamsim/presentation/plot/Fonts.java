package org.hificamsim.presentation.plot;

import java.awt.Font;
import java.awt.font.FontRenderContext;

/** The fonts of every picture. */
public final class Fonts {
  public static final Font TITLE = new Font(Font.SANS_SERIF, Font.BOLD, 14);
  public static final Font PANEL = new Font(Font.SANS_SERIF, Font.BOLD, 12);
  public static final Font TEXT = new Font(Font.SANS_SERIF, Font.PLAIN, 11);
  public static final Font TICKS = new Font(Font.SANS_SERIF, Font.PLAIN, 10);

  private static final FontRenderContext CONTEXT = new FontRenderContext(null, true, true);

  private Fonts() {}

  /** The width of a text, points. */
  public static int width(String text, Font font) {
    return (int) Math.ceil(font.getStringBounds(text, CONTEXT).getWidth());
  }
}
