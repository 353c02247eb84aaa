package org.hificamsim.presentation.plot;

import java.awt.Color;
import java.awt.Graphics2D;
import java.util.List;
import org.knowm.xchart.internal.chartpart.Chart;

/** Paints a figure: heading, legend, panels. */
final class FigurePainter {
  private static final Color NOTE_COLOR = new Color(0x555555);

  private final Figure figure;
  private final Graphics2D graphics;

  private FigurePainter(Figure figure, Graphics2D graphics) {
    this.figure = figure;
    this.graphics = graphics;
  }

  /** Paints in points. */
  static void paint(Figure figure, Graphics2D graphics) {
    FigurePainter painter = new FigurePainter(figure, graphics);
    painter.heading();
    figure.keys().paint(graphics, Figure.MARGIN, figure.top() - figure.keys().height());
    painter.panels();
  }

  private void heading() {
    graphics.setColor(Palette.BLACK);
    graphics.setFont(Fonts.TITLE);
    lines(figure.titleLines(), Figure.MARGIN + 14, Figure.HEADING);
    graphics.setColor(NOTE_COLOR);
    graphics.setFont(Fonts.TEXT);
    lines(figure.noteLines(), figure.noteTop() + 10, Figure.NOTE);
  }

  private void lines(List<String> lines, int first, int apart) {
    for (int i = 0; i < lines.size(); i++) {
      graphics.drawString(lines.get(i), Figure.MARGIN, first + i * apart);
    }
  }

  private void panels() {
    for (int i = 0; i < figure.panels().size(); i++) {
      Graphics2D place = (Graphics2D) graphics.create();
      place.translate(
          Figure.MARGIN + i % figure.columns() * figure.panelWidth(),
          figure.top() + i / figure.columns() * figure.panelHeight());
      panel(place, figure.panels().get(i));
      place.dispose();
    }
  }

  private void panel(Graphics2D place, Chart<?, ?> panel) {
    int title = panel.getTitle().isEmpty() ? 0 : Figure.PANEL_TITLE;
    place.setColor(Palette.BLACK);
    place.setFont(Fonts.PANEL);
    int width = Fonts.width(panel.getTitle(), Fonts.PANEL);
    place.drawString(panel.getTitle(), (figure.panelWidth() - width) / 2, title - 3);
    place.translate(0, title);
    panel.paint(place, figure.panelWidth(), figure.panelHeight() - title);
  }
}
