package org.hificamsim.presentation.picture;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.replay.Frame;

/**
 * Paints where each target went over the whole run, as the page's {@code tracks.js}: a line from
 * each place where it appeared, with a dot there, to where it was last seen. While it is away there
 * is no line.
 */
final class TrackPainter {
  private static final int MAX_POINTS = 200_000;
  private static final double STRENGTH = 0.45;
  private static final float WIDTH = 0.9f;
  private static final double DOT = 2.2;

  private final Graphics2D graphics;
  private final FieldMap map;
  private final RunFrames run;
  private final int every;

  TrackPainter(Graphics2D graphics, FieldMap map, RunFrames run) {
    this.graphics = graphics;
    this.map = map;
    this.run = run;
    long points = (long) run.count() * run.frame(0).x().length;
    this.every = (int) (1 + points / MAX_POINTS);
  }

  void paint() {
    graphics.setColor(Palette.pale(FieldPainter.INK, STRENGTH));
    graphics.setStroke(new BasicStroke(WIDTH, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    for (int target = 0; target < run.frame(0).x().length; target++) {
      graphics.draw(track(target));
    }
  }

  private Path2D track(int target) {
    Path2D path = new Path2D.Double();
    for (int i = 0; i < run.count(); i++) {
      Frame frame = run.frame(i);
      boolean was = i > 0 && run.frame(i - 1).present()[target];
      boolean stays = i + 1 < run.count() && run.frame(i + 1).present()[target];
      double x = map.x(frame.x()[target]);
      double y = map.y(frame.y()[target]);
      if (frame.present()[target] && !was) {
        graphics.fill(new Ellipse2D.Double(x - DOT, y - DOT, 2 * DOT, 2 * DOT));
        path.moveTo(x, y);
      } else if (frame.present()[target] && (i % every == 0 || !stays)) {
        path.lineTo(x, y);
      }
    }
    return path;
  }
}
