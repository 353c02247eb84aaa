package org.hificamsim.presentation.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.List;
import org.hificamsim.presentation.plot.Fonts;
import org.hificamsim.presentation.plot.Paintable;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.replay.PackedHeat.ShownFigure;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.runs.heat.HeatFigure;
import org.hificamsim.runs.heat.HeatMap;

/**
 * A picture of a heat map over the field. It also shows obstacles, the cameras after the last step,
 * and the tracks of targets if they are asked for.
 */
public final class HeatPicture implements Paintable {
  private static final int KEY_HEIGHT = 64;
  private static final int BAR_WIDTH = 300;
  private static final int BAR_HEIGHT = 12;
  private static final int GAP = 26;

  private final RunFrames run;
  private final HeatMap map;
  private final HeatFigure figure;
  private final int repeats;
  private final double[] values;
  private final double end;

  /**
   * @param run one of the runs of the map
   * @param repeats the number of runs of the map
   */
  public HeatPicture(RunFrames run, HeatMap map, HeatFigure figure, int repeats) {
    this.run = run;
    this.map = map;
    this.figure = figure;
    this.repeats = repeats;
    this.values = map.places().stream().mapToDouble(figure::figureOf).toArray();
    this.end = figure.end(map);
  }

  @Override
  public int width() {
    return StepPicture.WIDTH;
  }

  @Override
  public int height() {
    return (int) StepPicture.area(run).getMaxY() + KEY_HEIGHT + StepPicture.MARGIN;
  }

  @Override
  public void paint(Graphics2D graphics) {
    Setup setup = run.setup();
    graphics.setColor(Color.WHITE); // the last row of pixels may be incomplete
    graphics.fill(new Rectangle2D.Double(0, 0, width(), height() + 1.0));
    StepPicture.heading(
        graphics,
        setup.scenario() + ", heat map of " + steps(),
        run.scores().map(scores -> scores.text(scores.mean())),
        StepPicture.settings(setup, run.recording().seed()),
        map.shares());
    Rectangle2D area = StepPicture.area(run);
    FieldScript.Cells cells = new FieldScript.Cells(ShownFigure.of(figure, map), values);
    run.script().paint(graphics, area, run, run.count() - 1, cells);
    key(graphics, StepPicture.MARGIN, area.getMaxY() + 6);
  }

  private String steps() {
    String steps = (run.last() + 1) + " steps";
    return repeats == 1 ? steps : repeats + " runs of " + steps;
  }

  /** Paints the scale of colours with numbers, and the sign of cells that are never covered. */
  private void key(Graphics2D graphics, double left, double top) {
    text(graphics, figure.label(), left, top + 11);
    double bar = top + 18;
    List<Color> colors = run.script().scale(BAR_WIDTH);
    for (int i = 0; i < BAR_WIDTH; i++) {
      graphics.setColor(colors.get(i));
      graphics.fill(new Rectangle2D.Double(left + i, bar, Math.min(2, BAR_WIDTH - i), BAR_HEIGHT));
    }
    graphics.setStroke(new BasicStroke(0.8f));
    for (double tick : figure.ticks(end)) {
      double x = left + BAR_WIDTH * figure.share(tick, end);
      graphics.setColor(StepPicture.FAINT);
      graphics.draw(new Line2D.Double(x, bar + BAR_HEIGHT, x, bar + BAR_HEIGHT + 4));
      double start = x - Fonts.width(figure.tick(tick), Fonts.TEXT) / 2.0;
      text(graphics, figure.tick(tick), Math.max(left, start), bar + BAR_HEIGHT + 16);
    }
    if (Arrays.stream(values).anyMatch(value -> value == 0)) {
      double box = left + BAR_WIDTH + GAP;
      graphics.setPaint(run.script().neverCovered());
      graphics.fill(new Rectangle2D.Double(box, bar, 2 * BAR_HEIGHT, BAR_HEIGHT));
      text(graphics, figure.never(), box + 2 * BAR_HEIGHT + 6, bar + BAR_HEIGHT - 2);
    }
  }

  private static void text(Graphics2D graphics, String words, double x, double y) {
    graphics.setFont(Fonts.TEXT);
    graphics.setColor(Palette.BLACK);
    graphics.drawString(words, (float) x, (float) y);
  }
}
