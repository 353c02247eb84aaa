package org.hificamsim.tracks.place;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.file.PlainXml;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.place.DrawnPart.Traits;
import org.xml.sax.Attributes;

/**
 * Reads elements {@code <Line x1="" y1="" x2="" y2=""/>}, and the geometry of JuPedSim 0.8: the
 * polygons of its rooms are walls, those of its obstacles are solid; transitions and crossings are
 * doors, through which people pass.
 */
final class XmlWalls extends PlainXml {
  private final Drawing drawing;
  private final DrawingSettings settings;
  private PlanPoints points;
  private List<Point> polygon; // null outside a polygon
  private List<Label> labels = List.of();
  private boolean inObstacle;
  private String room = "";

  XmlWalls(Drawing drawing, DrawingSettings settings) {
    this.drawing = drawing;
    this.settings = settings;
    this.points = settings.points();
  }

  @Override
  public void startElement(String uri, String local, String name, Attributes attributes) {
    switch (name) {
      case "Line" -> addLine(name, attributes);
      case "geometry" -> readUnit(attributes);
      case "room" -> room = caption(attributes);
      case "obstacle" -> inObstacle = true;
      case "polygon" -> begin(attributes);
      case "vertex" -> addVertex(name, attributes);
      case "transition", "crossing" -> drawing.leaveOut(name);
      default -> {} // other elements, such as goals and stairs
    }
  }

  private void addLine(String name, Attributes attributes) {
    List<Point> ends =
        List.of(
            points.point(place(), number(attributes, name, "x1"), number(attributes, name, "y1")),
            points.point(place(), number(attributes, name, "x2"), number(attributes, name, "y2")));
    double height =
        attributes.getValue("height") == null
            ? Double.POSITIVE_INFINITY
            : drawing.height(() -> DrawnPart.height(place(), attributes.getValue("height")));
    drawing.add(place(), new DrawnShape.Line(ends), new Traits(height, List.of()));
  }

  private void readUnit(Attributes attributes) {
    String unit = attributes.getValue("unit");
    if (unit != null && settings.unit().isEmpty()) {
      Unit read =
          Spelling.find(Unit.class, unit)
              .filter(known -> known.metres() > 0)
              .orElseThrow(() -> place().invalid("<geometry> unit", unit, "m, cm or mm"));
      points = new PlanPoints(read, settings.projection());
    }
  }

  private static String caption(Attributes attributes) {
    String caption = attributes.getValue("caption");
    String id = attributes.getValue("id");
    return caption != null ? caption : id != null ? id : "";
  }

  private void begin(Attributes attributes) {
    polygon = new ArrayList<>();
    labels = new ArrayList<>();
    if (!room.isEmpty()) {
      labels.add(new Label("room", room));
    }
    if (!caption(attributes).isEmpty()) {
      labels.add(new Label(Label.CLASS, caption(attributes)));
    }
  }

  private void addVertex(String name, Attributes attributes) {
    if (polygon != null) {
      polygon.add(
          points.point(place(), number(attributes, name, "px"), number(attributes, name, "py")));
    }
  }

  @Override
  public void endElement(String uri, String local, String name) {
    if (name.equals("obstacle")) {
      inObstacle = false;
    } else if (name.equals("polygon") && polygon != null) {
      if (!polygon.isEmpty()) {
        DrawnShape shape =
            inObstacle ? new DrawnShape.Area(polygon, true) : new DrawnShape.Line(polygon);
        drawing.add(place(), shape, new Traits(Double.POSITIVE_INFINITY, labels));
      }
      polygon = null;
    }
  }
}
