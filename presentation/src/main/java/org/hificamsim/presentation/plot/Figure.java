package org.hificamsim.presentation.plot;

import java.awt.Color;
import java.awt.Graphics2D;
import java.util.List;
import org.knowm.xchart.internal.chartpart.Chart;

/**
 * A picture that has a title, a note, a legend for all panels, and the panels row by row.
 *
 * @param note a text about what is shown and how, which is broken into lines
 * @param columns the number of panels in a row
 * @param panelWidth the width of a panel in points; PNG files have twice as many pixels
 * @param panelHeight the height of a panel in points
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
  private static final int TITLE_LINE = 22;
  static final int NOTE_LINE = 16;
  private static final int LEGEND_ROW = 22;
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
    paint(graphics, titleLines(), MARGIN + 14, TITLE_LINE);
    graphics.setColor(NOTE_COLOR);
    graphics.setFont(Fonts.TEXT);
    paint(graphics, noteLines(), noteTop() + 10, NOTE_LINE);
    laidOutLegend().paint(graphics, MARGIN, top() - laidOutLegend().height());
    for (int i = 0; i < panels.size(); i++) {
      Graphics2D panelGraphics = (Graphics2D) graphics.create();
      panelGraphics.translate(MARGIN + i % columns * panelWidth, top() + i / columns * panelHeight);
      paint(panelGraphics, panels.get(i));
      panelGraphics.dispose();
    }
  }

  private static void paint(Graphics2D graphics, List<String> lines, int first, int lineHeight) {
    for (int i = 0; i < lines.size(); i++) {
      graphics.drawString(lines.get(i), MARGIN, first + i * lineHeight);
    }
  }

  private void paint(Graphics2D graphics, Chart<?, ?> panel) {
    int title = panel.getTitle().isEmpty() ? 0 : PANEL_TITLE;
    graphics.setColor(Palette.BLACK);
    graphics.setFont(Fonts.PANEL);
    int width = Fonts.width(panel.getTitle(), Fonts.PANEL);
    graphics.drawString(panel.getTitle(), (panelWidth - width) / 2, title - 3);
    graphics.translate(0, title);
    panel.paint(graphics, panelWidth, panelHeight - title);
  }

  /** Returns the top of the panels. */
  private int top() {
    return noteTop() + NOTE_LINE * noteLines().size() + laidOutLegend().height();
  }

  /** Returns the legend, laid out for the width of the figure. */
  private Legend laidOutLegend() {
    return new Legend(List.of(legend), width() - 2 * MARGIN, LegendEntry.WIDTH, LEGEND_ROW);
  }

  /** The top of the note. */
  private int noteTop() {
    return MARGIN + TITLE_LINE * titleLines().size();
  }

  /** The lines of the title; none if it is empty. */
  private List<String> titleLines() {
    return Fonts.lines(title, Fonts.TITLE, width() - 2 * MARGIN);
  }

  /** The lines of the note. */
  List<String> noteLines() {
    return Fonts.lines(note, Fonts.TEXT, width() - 2 * MARGIN);
  }

  private int rows() {
    return (panels.size() + columns - 1) / columns;
  }
}
