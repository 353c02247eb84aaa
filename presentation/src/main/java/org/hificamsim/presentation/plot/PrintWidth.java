package org.hificamsim.presentation.plot;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.core.InputException;

/**
 * The width of a figure in print, such as that of a journal's column. At any width, text has 8
 * points and numbers on axes have 7; panels that do not fit next to each other are placed below.
 *
 * @param millimetres the width, from 40 to 400
 */
public record PrintWidth(int millimetres) {
  private static final Pattern FORM = Pattern.compile("(\\d{1,4})mm");
  private static final int MIN = 40;
  private static final int MAX = 400;
  private static final double POINTS_PER_MILLIMETRE = 72 / 25.4;

  /** The ratio of sizes in print and on screens, which turns 11 points of text into 8. */
  private static final double SCALE = 0.72;

  /** The least width of a panel, in points on screens. */
  private static final int MIN_PANEL_WIDTH = 300;

  private static final int PIXELS_PER_INCH = 300;

  /**
   * Reads a width such as {@code 88mm}.
   *
   * @throws InputException if the text is not such a width
   */
  public static PrintWidth parse(String text) {
    Matcher form = FORM.matcher(text);
    if (form.matches()) {
      PrintWidth width = new PrintWidth(Integer.parseInt(form.group(1)));
      if (width.millimetres >= MIN && width.millimetres <= MAX) {
        return width;
      }
    }
    throw InputException.of(
        "%s is '%s', expected millimetres from %smm to %smm, such as 88mm or 180mm",
        setting("figure_width"), text, MIN, MAX);
  }

  /** Returns the figure with a layout for this width. */
  Figure of(Figure figure) {
    int contentWidth = (int) (millimetres * POINTS_PER_MILLIMETRE / SCALE) - 2 * Figure.MARGIN;
    int columns = Math.max(1, Math.min(figure.columns(), contentWidth / MIN_PANEL_WIDTH));
    return new Figure(
        "", // a paper has captions
        "",
        figure.legend(),
        figure.panels(),
        columns,
        contentWidth / columns,
        figure.panelHeight());
  }

  /** Converts a length in a figure to millimetres in print. */
  double printed(int points, Figure figure) {
    return (double) millimetres * points / figure.width();
  }

  /** The width in points. */
  double points() {
    return millimetres * POINTS_PER_MILLIMETRE;
  }

  /** The width in pixels. */
  int pixels() {
    return (int) Math.round(millimetres / 25.4 * PIXELS_PER_INCH);
  }
}
