package org.hificamsim.presentation.plot;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.core.InputException;

/**
 * The width of a figure in print, such as a journal's column. Text is printed at 8 points, numbers
 * on axes at 7, whatever the width; panels that do not fit side by side go below.
 *
 * @param millimetres 40 to 400
 */
public record PrintWidth(int millimetres) {
  private static final Pattern FORM = Pattern.compile("(\\d{1,4})mm");
  private static final int MIN = 40;
  private static final int MAX = 400;
  private static final double POINTS = 72 / 25.4; // a millimetre's

  /** Print over screen: makes 11 points of text 8. */
  private static final double SCALE = 0.72;

  private static final int MIN_PANEL = 300; // points, on the screen
  private static final int DOTS = 300; // an inch, of PNG files

  /**
   * Reads {@code 88mm}.
   *
   * @throws InputException when it is no such width
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

  /** The figure laid out again for this width. */
  Figure of(Figure figure) {
    int inside = (int) (millimetres * POINTS / SCALE) - 2 * Figure.MARGIN;
    int columns = Math.max(1, Math.min(figure.columns(), inside / MIN_PANEL));
    return new Figure(
        figure.title(),
        figure.note(),
        figure.legend(),
        figure.panels(),
        columns,
        inside / columns,
        figure.panelHeight());
  }

  /** A length of a figure's layout in print, millimetres. */
  double printed(int points, Figure figure) {
    return (double) millimetres * points / figure.width();
  }

  /** The width in points. */
  double points() {
    return millimetres * POINTS;
  }

  /** The width in pixels. */
  int pixels() {
    return (int) Math.round(millimetres / 25.4 * DOTS);
  }
}
