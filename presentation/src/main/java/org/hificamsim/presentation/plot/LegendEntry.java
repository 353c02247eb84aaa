package org.hificamsim.presentation.plot;

import java.awt.Color;

/** One line of a figure's legend. */
public record LegendEntry(String label, Color color, Mark mark) {
  /** How the thing is drawn. */
  public enum Mark {
    LINE,
    DASHES,
    BAR,
    DOT,
    DIAMOND
  }
}
