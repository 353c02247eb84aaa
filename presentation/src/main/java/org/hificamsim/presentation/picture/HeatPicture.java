package org.hificamsim.presentation.picture;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Rectangle2D;
import java.util.Locale;
import org.hificamsim.presentation.plot.Fonts;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.Picture;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.runs.heat.HeatFigure;
import org.hificamsim.runs.heat.HeatMap;

/**
 * A figure of a heat map over the field, with what stands in it, the cameras as the last step left
 * them and, if asked for, the tracks.
 */
public final class HeatPicture implements Picture {
  private static final int HEADING = 62;
  private static final int GAP = 6;

  private final RunFrames run;
  private final HeatLayer layer;
  private final int repeats;

  /**
   * @param run one of those that the map is of
   * @param repeats how many that are
   */
  public HeatPicture(RunFrames run, HeatMap map, HeatFigure figure, int repeats) {
    this.run = run;
    this.layer = new HeatLayer(map, figure);
    this.repeats = repeats;
  }

  @Override
  public int width() {
    return StepPicture.WIDTH;
  }

  @Override
  public int height() {
    return (int) area().getMaxY() + GAP + HeatLegend.HEIGHT + StepPicture.MARGIN;
  }

  private Rectangle2D area() {
    return StepPicture.area(run.setup().field(), HEADING);
  }

  @Override
  public void paint(Graphics2D graphics) {
    Rectangle2D area = area();
    Setup setup = run.setup();
    graphics.setColor(Color.WHITE); // to the end of a last row of pixels that is not whole
    graphics.fill(new Rectangle2D.Double(0, 0, width(), height() + 1.0));
    line(graphics, setup.scenario() + ", heat map of " + steps(), 12, true);
    line(graphics, StepPicture.settings(setup, run.recording().seed()), 29, false);
    line(graphics, covered(), 44, false);
    Shape before = graphics.getClip();
    graphics.clip(area);
    new FieldPainter(graphics, run, run.count() - 1, area).paintMap(layer);
    graphics.setClip(before);
    new HeatLegend(graphics, layer).paint(StepPicture.MARGIN, area.getMaxY() + GAP);
  }

  private String steps() {
    String steps = (run.last() + 1) + " steps";
    return repeats == 1 ? steps : repeats + " runs of " + steps;
  }

  private String covered() {
    HeatMap map = layer.map();
    return String.format(
        Locale.ROOT,
        "of area and steps %.1f %% covered by 1 or more cameras, %.1f %% by 2 or more;"
            + " of the area %.1f %% never",
        100 * map.covered(),
        100 * map.coveredK(),
        100 * map.blind());
  }

  private static void line(Graphics2D graphics, String text, int below, boolean title) {
    graphics.setFont(title ? Fonts.TITLE : Fonts.TEXT);
    graphics.setColor(title ? Palette.BLACK : FieldPainter.FAINT);
    graphics.drawString(text, StepPicture.MARGIN, StepPicture.MARGIN + below);
  }
}
