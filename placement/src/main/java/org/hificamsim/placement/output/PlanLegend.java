package org.hificamsim.placement.output;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.presentation.plot.Legend;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.Palette;

/** The legend of a drawn plan. */
final class PlanLegend {
  /** The dashed line by which the border of a zone is drawn. */
  static final BasicStroke ZONE_BORDER =
      new BasicStroke(
          1.3f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, new float[] {6, 3}, 0);

  private static final int SIGN_WIDTH = 22;
  private static final int ROW = 20;

  private final Legend legend;

  /**
   * @param strength the opacity of cells
   * @param hasSectors whether the drawing has sectors, which are to be explained
   */
  PlanLegend(CellClasses classes, double strength, boolean hasSectors) {
    List<LegendEntry> cells = new ArrayList<>();
    for (int i = 0; i < classes.colors().size(); i++) {
      Color color = Palette.pale(classes.colors().get(i), strength);
      cells.add(new LegendEntry(classes.labels().get(i), color, LegendEntry.Mark.BAR));
    }
    cells.add(
        new LegendEntry(
            "not asked for",
            (graphics, x, y) -> Hatching.paint(graphics, box(x, y), Hatching.NOT_ASKED_FOR)));
    List<LegendEntry> signs = new ArrayList<>(List.of(camera()));
    signs.addAll(hasSectors ? sectors() : List.of());
    signs.add(new LegendEntry("obstacle", Palette.BLACK, LegendEntry.Mark.BAR));
    signs.add(new LegendEntry("zone", PlanLegend::paintBorder));
    int width = PlanDrawing.WIDTH - 2 * PlanDrawing.MARGIN;
    this.legend = new Legend(List.of(cells, signs), width, SIGN_WIDTH, ROW);
  }

  private static LegendEntry camera() {
    return new LegendEntry(
        "camera",
        (graphics, x, y) -> PlanDrawing.paintSign(graphics, new Point2D.Double(x + 8, y), 90));
  }

  private static List<LegendEntry> sectors() {
    return List.of(
        new LegendEntry("seen as its zone asks", PlanLegend::paintSector),
        new LegendEntry(
            "blind zone, too near",
            (graphics, x, y) -> {
              paintSector(graphics, x, y);
              Hatching.paint(graphics, box(x, y), Hatching.BLIND_ZONE);
            }));
  }

  private static void paintBorder(Graphics2D graphics, int x, int y) {
    graphics.setColor(Palette.PURPLE.darker());
    graphics.setStroke(ZONE_BORDER);
    graphics.draw(new Line2D.Double(x, y, x + SIGN_WIDTH, y));
  }

  private static Rectangle2D box(int x, int y) {
    return new Rectangle2D.Double(x + 4, y - 6, 14, 12);
  }

  private static void paintSector(Graphics2D graphics, int x, int y) {
    graphics.setColor(Palette.pale(Palette.CAMERA, 0.1));
    graphics.fill(box(x, y));
    graphics.setColor(Palette.CAMERA);
    graphics.setStroke(new BasicStroke(0.8f));
    graphics.draw(box(x, y));
  }

  int height() {
    return legend.height();
  }

  void paint(Graphics2D graphics, int left, int top) {
    legend.paint(graphics, left, top);
  }
}
