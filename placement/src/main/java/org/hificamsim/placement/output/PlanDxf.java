package org.hificamsim.placement.output;

import java.awt.geom.Area;
import java.awt.geom.FlatteningPathIterator;
import java.io.IOException;
import java.io.Writer;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BiFunction;
import org.hificamsim.core.Texts;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.placement.site.CameraPlan;

/**
 * Writes a plan as a drawing for CAD programs (DXF), in metres and in the coordinates of the site.
 * Cameras, which are blocks with attributes, the sectors that they see, zones, walls and the field
 * are each on a layer of their own.
 */
final class PlanDxf {
  private static final String CAMERAS = "CAMERAS";
  private static final String SECTORS = "SECTORS";
  private static final String ZONES = "ZONES";
  private static final String WALLS = "WALLS";
  private static final String FIELD = "FIELD";

  /** The layers with their colours of the AutoCAD Color Index. */
  private static final Map<String, Integer> LAYERS =
      new TreeMap<>(Map.of(CAMERAS, 1, SECTORS, 4, ZONES, 3, WALLS, 7, FIELD, 8));

  private static final String BLOCK = "CAMERA";

  /** The value of the variable $INSUNITS for drawings in metres. */
  private static final int METRES = 6;

  /** The greatest distance of a curve from the lines that are drawn in its place, in metres. */
  private static final double FLATNESS = 0.02;

  /** The height of texts, in metres. */
  private static final double TEXT_HEIGHT = 0.3;

  /** The radius of a camera's symbol, in metres. */
  private static final double SYMBOL_RADIUS = 0.2;

  /** The attributes of a camera's block, by tag. Programs show the name only. */
  private static final Map<String, BiFunction<CameraPlan, CameraSpec, String>> ATTRIBUTES =
      new LinkedHashMap<>();

  static {
    ATTRIBUTES.put("NAME", (plan, camera) -> camera.name());
    ATTRIBUTES.put("LENS", (plan, camera) -> camera.optics().map(OpticsSpec::name).orElse(""));
    ATTRIBUTES.put("HEADING", (plan, camera) -> number(camera.heading()));
    ATTRIBUTES.put("TILT", (plan, camera) -> number(camera.tilt()));
    ATTRIBUTES.put("HEIGHT", (plan, camera) -> number(plan.height(camera)));
    ATTRIBUTES.put("ANGLE", (plan, camera) -> number(camera.viewingAngle()));
    ATTRIBUTES.put("PRICE", (plan, camera) -> number(camera.price()));
  }

  private final CameraPlan plan;
  private final Scenario site;
  private final CameraSectors sectors;
  private final DxfWriter dxf;

  private PlanDxf(CameraPlan plan, CameraSectors sectors, Writer out) {
    this.plan = plan;
    this.site = plan.scenario();
    this.sectors = sectors;
    this.dxf = new DxfWriter(out);
  }

  static void write(Writer out, CameraPlan plan, CameraSectors sectors) throws IOException {
    new PlanDxf(plan, sectors, out).write();
  }

  private void write() throws IOException {
    header();
    layers();
    blocks();
    dxf.begin("ENTITIES");
    Field field = site.field();
    dxf.polyline(FIELD, corners(field.minX(), field.minY(), field.maxX(), field.maxY()), true);
    for (Obstacle obstacle : site.obstacles()) {
      obstacle(obstacle);
    }
    for (Zone zone : site.zones()) {
      zone(zone);
    }
    for (int camera = 0; camera < plan.cameras().size(); camera++) {
      Area seen = sectors.sector(camera);
      dxf.path(SECTORS, new FlatteningPathIterator(seen.getPathIterator(null), FLATNESS));
      camera(plan.cameras().get(camera));
    }
    dxf.end();
    dxf.pair(0, "EOF");
  }

  private static List<Point> corners(double minX, double minY, double maxX, double maxY) {
    return List.of(
        new Point(minX, minY), new Point(maxX, minY), new Point(maxX, maxY), new Point(minX, maxY));
  }

  private void header() throws IOException {
    dxf.begin("HEADER");
    dxf.pair(9, "$ACADVER");
    dxf.pair(1, "AC1009");
    dxf.pair(9, "$INSUNITS");
    dxf.pair(70, METRES);
    dxf.end();
  }

  private void layers() throws IOException {
    dxf.begin("TABLES");
    dxf.pair(0, "TABLE");
    dxf.pair(2, "LAYER");
    dxf.pair(70, LAYERS.size());
    for (Map.Entry<String, Integer> layer : LAYERS.entrySet()) {
      dxf.pair(0, "LAYER");
      dxf.pair(2, layer.getKey());
      dxf.pair(70, 0);
      dxf.pair(62, layer.getValue());
      dxf.pair(6, "CONTINUOUS");
    }
    dxf.pair(0, "ENDTAB");
    dxf.end();
  }

  /** Writes the block that stands for a camera: a circle with a line towards its heading. */
  private void blocks() throws IOException {
    dxf.begin("BLOCKS");
    dxf.entity("BLOCK", "0");
    dxf.pair(2, BLOCK);
    dxf.pair(70, 2); // has attributes
    dxf.point(10, 0, 0);
    dxf.pair(3, BLOCK);
    dxf.circle("0", new Point(0, 0), SYMBOL_RADIUS);
    dxf.line("0", new Point(0, 0), new Point(0, 2.5 * SYMBOL_RADIUS));
    int row = 0;
    for (String tag : ATTRIBUTES.keySet()) {
      dxf.entity("ATTDEF", "0");
      dxf.point(10, 2 * SYMBOL_RADIUS, -row * TEXT_HEIGHT);
      dxf.number(40, TEXT_HEIGHT);
      dxf.pair(1, "");
      dxf.pair(3, tag);
      dxf.pair(2, tag);
      dxf.pair(70, row++ == 0 ? 0 : 1); // all but the name are invisible
    }
    dxf.entity("ENDBLK", "0");
    dxf.end();
  }

  private void obstacle(Obstacle obstacle) throws IOException {
    if (obstacle instanceof Obstacle.Wall wall) {
      dxf.line(WALLS, new Point(wall.x1(), wall.y1()), new Point(wall.x2(), wall.y2()));
    } else if (obstacle instanceof Obstacle.Polygon polygon) {
      dxf.polyline(WALLS, polygon.points(), true);
    } else if (obstacle instanceof Obstacle.Pillar pillar) {
      dxf.circle(WALLS, new Point(pillar.x(), pillar.y()), pillar.radius());
    }
  }

  private void zone(Zone zone) throws IOException {
    List<Point> points = zone.points();
    switch (zone.shape()) {
      case RECTANGLE -> {
        Point end = points.get(1);
        dxf.polyline(ZONES, corners(points.get(0).x(), points.get(0).y(), end.x(), end.y()), true);
      }
      case POLYGON -> dxf.polyline(ZONES, points, true);
      case POLYLINE -> dxf.polyline(ZONES, points, false);
      case FIELD -> {} // drawn as the field
    }
    if (!points.isEmpty()) {
      dxf.label(ZONES, points.get(0), TEXT_HEIGHT, zone.name());
    }
  }

  private static String number(double value) {
    return Double.isNaN(value) ? "" : Texts.format("%.2f", value);
  }

  private void camera(CameraSpec camera) throws IOException {
    dxf.entity("INSERT", CAMERAS);
    dxf.pair(66, 1);
    dxf.pair(2, BLOCK);
    dxf.point(10, camera.x(), camera.y());
    dxf.number(50, -camera.heading()); // a heading is clockwise from +y
    int row = 0;
    for (var attribute : ATTRIBUTES.entrySet()) {
      dxf.entity("ATTRIB", CAMERAS);
      dxf.point(10, camera.x() + 2 * SYMBOL_RADIUS, camera.y() - row * TEXT_HEIGHT);
      dxf.number(40, TEXT_HEIGHT);
      dxf.text(1, attribute.getValue().apply(plan, camera));
      dxf.pair(2, attribute.getKey());
      dxf.pair(70, row++ == 0 ? 0 : 1);
    }
    dxf.entity("SEQEND", CAMERAS);
  }
}
