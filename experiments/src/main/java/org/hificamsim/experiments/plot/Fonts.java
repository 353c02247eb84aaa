package org.hificamsim.experiments.plot;

import java.awt.Font;

/** The fonts of every picture. */
final class Fonts {
  static final Font TITLE = new Font(Font.SANS_SERIF, Font.BOLD, 14);
  static final Font PANEL = new Font(Font.SANS_SERIF, Font.BOLD, 12);
  static final Font TEXT = new Font(Font.SANS_SERIF, Font.PLAIN, 11);
  static final Font TICKS = new Font(Font.SANS_SERIF, Font.PLAIN, 10);

  private Fonts() {}
}
