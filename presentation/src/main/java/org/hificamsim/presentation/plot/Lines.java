package org.hificamsim.presentation.plot;

import java.awt.Font;
import java.util.ArrayList;
import java.util.List;

/** A text in lines that fit, broken between words. */
final class Lines {
  private Lines() {}

  /**
   * The lines; a word that is too long has one of its own.
   *
   * @param width points
   */
  static List<String> of(String text, Font font, int width) {
    List<String> lines = new ArrayList<>();
    String line = "";
    for (String word : text.split(" ")) {
      String longer = line.isEmpty() ? word : line + " " + word;
      if (!line.isEmpty() && Fonts.width(longer, font) > width) {
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
