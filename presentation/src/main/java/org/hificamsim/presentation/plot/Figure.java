package org.hificamsim.presentation.plot;

import java.awt.Color;
import java.awt.Graphics2D;
import java.util.List;
import org.knowm.xchart.internal.chartpart.Chart;

/**
 * A picture: a title, a legend common to all panels, and the panels row by row.
 *
 * @param note what is shown and how, under the title, in as many lines as it needs
 * @param columns panels in a row
 * @param panelWidth in points, as papers measure; PNG files have twice as many pixels
 * @param panelHeight in points
 */
public record Figure(
    String title,
    String note,
    List<LegendEntry> legend,
    List<? extends Chart<?, ?>> panels,
    int columns,
    int panelWidth,
    int panelHeight)
    implements Paintable {
  private static final int HEADING = 22;
  static final int NOTE = 16;
  private static final int LEGEND = 22;
  private static final int PANEL_TITLE = 20;
  static final int MARGIN = 10;
  private static final Color NOTE_COLOR = new Color(0x555555);

  public Figure {
    legend = List.copyOf(legend);
    panels = List.copyOf(panels);
  }

  @Override
  public int width() {
    return columns * panelWidth + 2 * MARGIN;
  }

  @Override
  public int height() {
    return top() + rows() * panelHeight + MARGIN;
  }

  @Override
  public void paint(Graphics2D graphics) {
    graphics.setColor(Palette.BLACK);
    graphics.setFont(Fonts.TITLE);
    paint(graphics, titleLines(), MARGIN + 14, HEADING);
    graphics.setColor(NOTE_COLOR);
    graphics.setFont(Fonts.TEXT);
    paint(graphics, noteLines(), noteTop() + 10, NOTE);
    keys().paint(graphics, MARGIN, top() - keys().height());
    for (int i = 0; i < panels.size(); i++) {
      Graphics2D place = (Graphics2D) graphics.create();
      place.translate(MARGIN + i % columns * panelWidth, top() + i / columns * panelHeight);
      paint(place, panels.get(i));
      place.dispose();
    }
  }

  private static void paint(Graphics2D graphics, List<String> lines, int first, int apart) {
    for (int i = 0; i < lines.size(); i++) {
      graphics.drawString(lines.get(i), MARGIN, first + i * apart);
    }
  }

  private void paint(Graphics2D place, Chart<?, ?> panel) {
    int title = panel.getTitle().isEmpty() ? 0 : PANEL_TITLE;
    place.setColor(Palette.BLACK);
    place.setFont(Fonts.PANEL);
    int width = Fonts.width(panel.getTitle(), Fonts.PANEL);
    place.drawString(panel.getTitle(), (panelWidth - width) / 2, title - 3);
    place.translate(0, title);
    panel.paint(place, panelWidth, panelHeight - title);
  }

  /** Where the panels begin. */
  private int top() {
    return noteTop() + NOTE * noteLines().size() + keys().height();
  }

  /** The legend as it is laid out. */
  private Legend keys() {
    return new Legend(List.of(legend), width() - 2 * MARGIN, LegendEntry.WIDTH, LEGEND);
  }

  /** Where the note begins. */
  private int noteTop() {
    return MARGIN + HEADING * titleLines().size();
  }

  /** The title, line by line; of an empty one, the room for it. */
  private List<String> titleLines() {
    List<String> lines = Fonts.lines(title, Fonts.TITLE, width() - 2 * MARGIN);
    return lines.isEmpty() ? List.of("") : lines;
  }

  /** The note, line by line. */
  List<String> noteLines() {
    return Fonts.lines(note, Fonts.TEXT, width() - 2 * MARGIN);
  }

  private int rows() {
    return (panels.size() + columns - 1) / columns;
  }
}
