package org.hificamsim.presentation.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.stream.IntStream;
import org.hificamsim.presentation.plot.Fonts;
import org.hificamsim.presentation.plot.Palette;

/** k_min over all steps, with a line at the step that is shown. */
final class KMinStrip {
  private static final int AXIS = 14;
  private static final Color LINE = Palette.BLUE;

  private final Graphics2D graphics;
  private final RunFrames run;
  private final Rectangle2D plot;
  private final int most;

  KMinStrip(Graphics2D graphics, RunFrames run, Rectangle2D area) {
    this.graphics = graphics;
    this.run = run;
    this.plot =
        new Rectangle2D.Double(area.getX(), area.getY(), area.getWidth(), area.getHeight() - AXIS);
    this.most = Math.max(1, IntStream.range(0, run.count()).map(run::kMin).max().orElseThrow());
  }

  /**
   * @param index the frame that is shown
   */
  void paint(int index) {
    graphics.setFont(Fonts.TICKS);
    graphics.setStroke(new BasicStroke(0.8f));
    int gap = Math.max(1, (int) FieldPainter.niceGap(most / 4.0));
    for (int k = 0; k <= most; k += gap) {
      graphics.setColor(FieldPainter.GRID);
      graphics.draw(new Line2D.Double(plot.getMinX(), y(k), plot.getMaxX(), y(k)));
      text(Integer.toString(k), plot.getMinX() - 5, y(k) + 4, 1);
    }
    text("k_min", plot.getMinX(), plot.getMinY() - 6, 0);
    text("step 0", plot.getMinX(), plot.getMaxY() + AXIS, 0);
    text(Long.toString(run.last()), plot.getMaxX(), plot.getMaxY() + AXIS, 1);
    curve();
    graphics.setStroke(new BasicStroke(1.5f));
    graphics.setColor(FieldPainter.INK);
    graphics.draw(new Line2D.Double(x(index), plot.getMinY() - 3, x(index), plot.getMaxY() + 3));
  }

  private void curve() {
    Path2D path = new Path2D.Double();
    path.moveTo(x(0), y(run.kMin(0)));
    for (int i = 1; i < run.count(); i++) {
      if (run.kMin(i) != run.kMin(i - 1)) {
        path.lineTo(x(i), y(run.kMin(i - 1)));
        path.lineTo(x(i), y(run.kMin(i)));
      }
    }
    path.lineTo(plot.getMaxX(), y(run.kMin(run.count() - 1)));
    graphics.setStroke(new BasicStroke(1));
    graphics.setColor(LINE);
    graphics.draw(path);
  }

  private double x(int index) {
    return plot.getMinX() + plot.getWidth() * run.step(index) / Math.max(1, run.last());
  }

  private double y(int k) {
    return plot.getMaxY() - plot.getHeight() * k / most;
  }

  /**
   * @param right share of the text's width that lies left of x
   */
  private void text(String text, double x, double y, double right) {
    graphics.setColor(FieldPainter.FAINT);
    double left = x - right * Fonts.width(text, Fonts.TICKS);
    graphics.drawString(text, (float) left, (float) y);
  }
}
