package org.hificamsim.presentation.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Paint;
import java.awt.RenderingHints;
import java.awt.TexturePaint;
import java.awt.geom.AffineTransform;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.runs.heat.Cells;
import org.hificamsim.runs.heat.HeatFigure;
import org.hificamsim.runs.heat.HeatMap;

/**
 * One figure of a heat map in colours: those of the page's {@code heat.js}.
 *
 * @param end of the colour scale
 */
record HeatLayer(HeatMap map, HeatFigure figure, double end) {
  /** How much of what is below is covered. */
  static final double STRENGTH = 0.8;

  /** What no camera ever covers, as a target that none does: hatched. */
  static final Color NEVER = CoverClass.NONE.color();

  static final double NEVER_GROUND = 0.22;
  private static final int HATCH = 14; // pixels

  /** Viewers of SVG files blur pixels: these are cells many pixels wide. */
  private static final int PIXELS = 1600;

  HeatLayer(HeatMap map, HeatFigure figure) {
    this(map, figure, figure.end(map));
  }

  /** How a cell with this figure, not NaN, is filled. */
  private Paint fill(double value) {
    return value == 0
        ? never(HATCH)
        : Palette.pale(Palette.scale(figure.share(value, end)), STRENGTH);
  }

  /**
   * Diagonal lines on a pale ground, for an image in pixels.
   *
   * @param side from line to line, pixels
   */
  private static Paint never(int side) {
    BufferedImage tile = new BufferedImage(side, side, BufferedImage.TYPE_INT_ARGB);
    Graphics2D pixels = tile.createGraphics();
    pixels.setColor(Palette.pale(NEVER, NEVER_GROUND));
    pixels.fillRect(0, 0, side, side);
    pixels.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    pixels.setColor(Palette.pale(NEVER, STRENGTH));
    pixels.setStroke(new BasicStroke(side / 7f));
    for (int from = -side; from <= side; from += side) {
      pixels.drawLine(from, side, from + side, 0);
    }
    pixels.dispose();
    return new TexturePaint(tile, new Rectangle2D.Double(0, 0, side, side));
  }

  /** Paints the cells; those that have nothing to show are left as they are. */
  void paint(Graphics2D graphics, FieldMap field) {
    BufferedImage image = image();
    Rectangle2D area = field.rectangle(map.cells().field());
    AffineTransform place = AffineTransform.getTranslateInstance(area.getX(), area.getY());
    place.scale(area.getWidth() / image.getWidth(), area.getHeight() / image.getHeight());
    graphics.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
    graphics.drawImage(image, place, null);
  }

  private BufferedImage image() {
    Cells cells = map.cells();
    int edge = Math.max(1, PIXELS / Math.max(cells.columns(), cells.rows()));
    BufferedImage image =
        new BufferedImage(edge * cells.columns(), edge * cells.rows(), BufferedImage.TYPE_INT_ARGB);
    Graphics2D pixels = image.createGraphics();
    for (int cell = 0; cell < cells.count(); cell++) {
      double value = figure.of(map.places().get(cell));
      if (!Double.isNaN(value)) {
        pixels.setPaint(fill(value));
        int fromTop = cells.rows() - 1 - cell / cells.columns();
        pixels.fillRect(edge * (cell % cells.columns()), edge * fromTop, edge, edge);
      }
    }
    pixels.dispose();
    return image;
  }
}
