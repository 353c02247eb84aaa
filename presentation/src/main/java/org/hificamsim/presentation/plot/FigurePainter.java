package org.hificamsim.presentation.plot;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.knowm.xchart.internal.chartpart.Chart;

/** Paints a figure: heading, legend, panels. */
final class FigurePainter {
  private static final Color NOTE_COLOR = new Color(0x555555);
  private static final float[] DASHES = {5, 4};

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
    painter.legend();
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

  private void legend() {
    LegendLayout layout = LegendLayout.of(figure);
    int first = figure.top() - layout.rows() * Figure.LEGEND;
    graphics.setFont(Fonts.TEXT);
    for (LegendLayout.Place place : layout.places()) {
      int middle = first + place.row() * Figure.LEGEND + Figure.LEGEND / 2;
      graphics.setColor(place.entry().color());
      mark(place.entry().mark(), place.x(), middle);
      graphics.setColor(Palette.BLACK);
      graphics.drawString(place.entry().label(), place.textX(), middle + 4);
    }
  }

  private void mark(LegendEntry.Mark mark, int x, int y) {
    int middle = x + LegendLayout.MARK / 2;
    switch (mark) {
      case LINE -> line(x, y, new BasicStroke(2.5f));
      case DASHES ->
          line(
              x,
              y,
              new BasicStroke(2, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, DASHES, 0));
      case BAR -> graphics.fill(new Rectangle2D.Double(x + 4, y - 6, 14, 12));
      case DOT -> graphics.fill(new Ellipse2D.Double(middle - 4, y - 4, 8, 8));
      case DIAMOND -> graphics.fill(diamond(middle, y));
    }
  }

  private void line(int x, int y, BasicStroke stroke) {
    graphics.setStroke(stroke);
    graphics.draw(new Line2D.Double(x, y, x + LegendLayout.MARK, y));
  }

  private static Shape diamond(int x, int y) {
    Path2D path = new Path2D.Double();
    path.moveTo(x, y - 5);
    path.lineTo(x + 5, y);
    path.lineTo(x, y + 5);
    path.lineTo(x - 5, y);
    path.closePath();
    return path;
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
