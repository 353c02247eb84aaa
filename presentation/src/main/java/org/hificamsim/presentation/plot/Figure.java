package org.hificamsim.presentation.plot;

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
    implements Picture {
  static final int HEADING = 22;
  static final int NOTE = 16;
  static final int LEGEND = 22;
  static final int PANEL_TITLE = 20;
  static final int MARGIN = 10;

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
    FigurePainter.paint(this, graphics);
  }

  /** Where the panels begin. */
  int top() {
    return noteTop() + NOTE * noteLines().size() + keys().height();
  }

  /** The legend as it is laid out. */
  Legend keys() {
    List<Legend.Entry> entries = legend.stream().map(LegendEntry::entry).toList();
    return new Legend(List.of(entries), width() - 2 * MARGIN, LegendEntry.WIDTH, LEGEND);
  }

  /** Where the note begins. */
  int noteTop() {
    return MARGIN + HEADING * titleLines().size();
  }

  /** The title, line by line; of an empty one, the room for it. */
  List<String> titleLines() {
    List<String> lines = Lines.of(title, Fonts.TITLE, width() - 2 * MARGIN);
    return lines.isEmpty() ? List.of("") : lines;
  }

  /** The note, line by line. */
  List<String> noteLines() {
    return Lines.of(note, Fonts.TEXT, width() - 2 * MARGIN);
  }

  private int rows() {
    return (panels.size() + columns - 1) / columns;
  }
}
