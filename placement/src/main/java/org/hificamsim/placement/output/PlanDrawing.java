package org.hificamsim.placement.output;

import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.placement.site.CameraPlan;
import org.hificamsim.presentation.plot.Fonts;
import org.hificamsim.presentation.plot.Paintable;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.replay.FloorPictures;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.runs.cells.FieldCells;

/**
 * A picture of a plan, drawn to scale. It shows cells in the colours of their classes, the sector
 * that each camera sees with its blind zone hatched, obstacles, zones, and names of cameras and
 * zones. A scale bar, an arrow to the north, and a legend are below it.
 */
final class PlanDrawing implements Paintable {
  static final int WIDTH = 800;
  static final int MARGIN = 12;
  private static final int MAX_HEIGHT = 900;

  /** The height of the strip with the scale bar. */
  private static final int SCALE_BAR_HEIGHT = 34;

  private static final double CELL_STRENGTH = 0.4;
  private static final double SECTOR_STRENGTH = 0.04;

  /** The width by which neighbouring cells overlap, so that no gaps show between them. */
  private static final double OVERLAP = 0.4;

  /** The radius of the dot that marks a camera. */
  private static final double DOT_RADIUS = 4;

  private final Scenario site;
  private final List<CameraSpec> cameras;
  private final CellClasses classes;
  private final List<Setup.Floor> floor;
  private final List<CameraSectors.Sector> sectors;
  private final AffineTransform toPaper;
  private final Rectangle2D area;
  private final PlanLegend legend;

  /**
   * @param sectors the sectors of all cameras; empty if none are to be drawn, which would change
   *     the colours of cells
   * @param floor pictures to be shown below the plan
   */
  PlanDrawing(
      CameraPlan plan,
      CellClasses classes,
      List<CameraSectors.Sector> sectors,
      List<Setup.Floor> floor) {
    this.site = plan.scenario();
    this.cameras = plan.cameras();
    this.classes = classes;
    this.sectors = sectors;
    this.floor = floor;
    Field field = site.field();
    double scale = Math.min((WIDTH - 2.0 * MARGIN) / field.width(), MAX_HEIGHT / field.height());
    double left = (WIDTH - scale * field.width()) / 2;
    this.area = new Rectangle2D.Double(left, MARGIN, scale * field.width(), scale * field.height());
    this.toPaper =
        new AffineTransform(
            scale, 0, 0, -scale, left - scale * field.minX(), MARGIN + scale * field.maxY());
    this.legend = new PlanLegend(classes, CELL_STRENGTH, !sectors.isEmpty());
  }

  /** The scale of the drawing. */
  double pointsPerMetre() {
    return toPaper.getScaleX();
  }

  @Override
  public int width() {
    return WIDTH;
  }

  @Override
  public int height() {
    return (int) Math.ceil(area.getMaxY()) + SCALE_BAR_HEIGHT + legend.height();
  }

  @Override
  public void paint(Graphics2D graphics) {
    Graphics2D inside = (Graphics2D) graphics.create();
    inside.clip(area);
    paintFloor(inside);
    paintCells(inside);
    sectors.forEach(sector -> paintSector(inside, sector));
    inside.setColor(Palette.BLACK);
    site.obstacles().forEach(obstacle -> ObstacleShape.paint(inside, obstacle, toPaper));
    paintZones(inside);
    inside.dispose();
    graphics.setColor(Palette.BLACK);
    graphics.setStroke(new BasicStroke(1));
    graphics.draw(area);
    paintCameras(graphics);
    ScaleBar.paint(graphics, area, toPaper.getScaleX());
    legend.paint(graphics, MARGIN, (int) Math.ceil(area.getMaxY()) + SCALE_BAR_HEIGHT);
  }

  private void paintFloor(Graphics2D graphics) {
    Graphics2D pale = (Graphics2D) graphics.create();
    pale.setComposite(AlphaComposite.getInstance(AlphaComposite.SRC_OVER, 0.5f));
    for (Setup.Floor picture : floor) {
      BufferedImage image = FloorPictures.image(picture);
      Rectangle2D place = onPaper(picture.area()).getBounds2D();
      // Scales in SVG are rounded to two decimals, which would move a large picture off its place.
      // So the picture is drawn to whole pixels.
      int left = (int) Math.round(place.getMinX());
      int top = (int) Math.round(place.getMinY());
      int width = (int) Math.round(place.getMaxX()) - left;
      int height = (int) Math.round(place.getMaxY()) - top;
      pale.drawImage(image, left, top, width, height, null);
    }
    pale.dispose();
  }

  private Shape onPaper(Field field) {
    return toPaper.createTransformedShape(
        new Rectangle2D.Double(field.minX(), field.minY(), field.width(), field.height()));
  }

  private void paintCells(Graphics2D graphics) {
    for (int number = 0; number < classes.colors().size(); number++) {
      double value = number;
      graphics.setColor(Palette.pale(classes.colors().get(number), CELL_STRENGTH));
      graphics.fill(cells(cell -> classes.values()[cell] == value));
    }
    Shape rest = cells(cell -> Double.isNaN(classes.values()[cell]));
    Hatching.paint(graphics, rest, Hatching.NOT_ASKED_FOR);
  }

  private interface CellChoice {
    boolean has(int cell);
  }

  private Shape cells(CellChoice choice) {
    FieldCells cells = classes.cells();
    double width = cells.width() * toPaper.getScaleX();
    double height = -cells.height() * toPaper.getScaleY();
    Path2D path = new Path2D.Double(Path2D.WIND_NON_ZERO);
    for (int cell = 0; cell < cells.count(); cell++) {
      if (choice.has(cell)) {
        Point2D middle = onPaper(cells.x(cell), cells.y(cell));
        path.append(
            new Rectangle2D.Double(
                middle.getX() - width / 2 - OVERLAP / 2,
                middle.getY() - height / 2 - OVERLAP / 2,
                width + OVERLAP,
                height + OVERLAP),
            false);
      }
    }
    return path;
  }

  private Point2D onPaper(double x, double y) {
    return toPaper.transform(new Point2D.Double(x, y), null);
  }

  private void paintSector(Graphics2D graphics, CameraSectors.Sector sector) {
    Shape area = toPaper.createTransformedShape(sector.area());
    graphics.setColor(Palette.pale(Palette.CAMERA, SECTOR_STRENGTH));
    graphics.fill(area);
    Shape blindZone = toPaper.createTransformedShape(sector.blindZone());
    Hatching.paint(graphics, blindZone, Hatching.BLIND_ZONE);
    graphics.setColor(Palette.CAMERA);
    graphics.setStroke(new BasicStroke(0.8f));
    graphics.draw(area);
  }

  private void paintZones(Graphics2D graphics) {
    graphics.setColor(Palette.PURPLE.darker());
    graphics.setStroke(PlanLegend.ZONE_BORDER);
    for (Zone zone : site.zones()) {
      graphics.draw(toPaper.createTransformedShape(ObstacleShape.outline(zone)));
    }
  }

  private void paintCameras(Graphics2D graphics) {
    LabelPlaces places = new LabelPlaces(area);
    cameras.forEach(camera -> places.avoid(onPaper(camera.x(), camera.y()), DOT_RADIUS + 1));
    for (CameraSpec camera : cameras) {
      Point2D point = onPaper(camera.x(), camera.y());
      paintSign(graphics, point, camera.heading());
      paintName(graphics, camera.name(), point, places);
    }
    for (Zone zone : site.zones()) {
      if (zone.shape() != Zone.Shape.FIELD) {
        Field bounds = zone.bounds(site.field());
        Point2D corner = onPaper(bounds.minX() + bounds.width() / 2, bounds.maxY());
        paintZoneName(graphics, zone.name(), corner, places);
      }
    }
  }

  /** Paints the sign of a camera: a dot with a line in the direction of its heading. */
  static void paintSign(Graphics2D graphics, Point2D point, double heading) {
    double x = point.getX();
    double y = point.getY();
    double radians = Math.toRadians(heading);
    graphics.setColor(Palette.CAMERA);
    graphics.setStroke(new BasicStroke(2));
    graphics.draw(new Line2D.Double(x, y, x + 9 * Math.sin(radians), y - 9 * Math.cos(radians)));
    graphics.fill(
        new Ellipse2D.Double(x - DOT_RADIUS, y - DOT_RADIUS, 2 * DOT_RADIUS, 2 * DOT_RADIUS));
  }

  private static void paintName(
      Graphics2D graphics, String name, Point2D point, LabelPlaces places) {
    Rectangle2D place = places.place(point, Fonts.width(name, Fonts.PANEL) + 4, 15);
    graphics.setColor(Palette.CAMERA);
    graphics.setStroke(new BasicStroke(0.7f));
    if (point.distance(place.getCenterX(), place.getCenterY()) > place.getWidth() / 2 + 16) {
      graphics.draw(
          new Line2D.Double(point, new Point2D.Double(place.getCenterX(), place.getCenterY())));
    }
    paintLabel(graphics, name, place);
  }

  private static void paintLabel(Graphics2D graphics, String name, Rectangle2D place) {
    Color ink = graphics.getColor();
    graphics.setColor(Palette.pale(Color.WHITE, 0.85));
    graphics.fill(place);
    graphics.setColor(ink.darker());
    graphics.setFont(Fonts.PANEL);
    graphics.drawString(name, (float) place.getX() + 2, (float) place.getMaxY() - 3);
  }

  private static void paintZoneName(
      Graphics2D graphics, String name, Point2D point, LabelPlaces places) {
    graphics.setColor(Palette.PURPLE.darker());
    paintLabel(graphics, name, places.place(point, Fonts.width(name, Fonts.PANEL) + 4, 15));
  }
}
