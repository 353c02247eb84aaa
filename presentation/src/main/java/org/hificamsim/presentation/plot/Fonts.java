package org.hificamsim.presentation.plot;

import java.awt.Font;
import java.awt.font.FontRenderContext;
import java.awt.font.TextLayout;
import java.util.ArrayList;
import java.util.List;

/** The fonts of all pictures. */
public final class Fonts {
  public static final Font TITLE = new Font(Font.SANS_SERIF, Font.BOLD, 14);
  public static final Font PANEL = new Font(Font.SANS_SERIF, Font.BOLD, 12);
  public static final Font TEXT = new Font(Font.SANS_SERIF, Font.PLAIN, 11);
  public static final Font TICKS = new Font(Font.SANS_SERIF, Font.PLAIN, 10);

  private static final FontRenderContext CONTEXT = new FontRenderContext(null, true, true);

  static {
    measureOnce();
  }

  private Fonts() {}

  /**
   * Measures once in one thread. If two threads started at the same time, some widths of a bold
   * font were wrong in the whole process (2 of 1,500 on Java 17).
   */
  private static void measureOnce() {
    for (Font font : List.of(TITLE, TEXT)) {
      width("a", font);
      new TextLayout("a", font, CONTEXT).getOutline(null);
    }
  }

  /** The width of a text, in points. */
  public static int width(String text, Font font) {
    return (int) Math.ceil(font.getStringBounds(text, CONTEXT).getWidth());
  }

  /**
   * Breaks a text into lines between words; a word that is too long gets a line of its own.
   *
   * @param width points
   */
  static List<String> lines(String text, Font font, int width) {
    List<String> lines = new ArrayList<>();
    String line = "";
    for (String word : text.split(" ")) {
      String longer = line.isEmpty() ? word : line + " " + word;
      if (!line.isEmpty() && width(longer, font) > width) {
        lines.add(line);
        longer = word;
      }
      line = longer;
    }
    if (!line.isEmpty()) {
      lines.add(line);
    }
    return lines;
  }
}
