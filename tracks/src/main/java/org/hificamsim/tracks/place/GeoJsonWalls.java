package org.hificamsim.tracks.place;

import com.fasterxml.jackson.core.JsonToken;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.Place;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.data.JsonStream;
import org.hificamsim.tracks.format.Positions;
import org.hificamsim.tracks.place.DrawnPart.Traits;
import org.hificamsim.tracks.place.DrawnShape.Area;

/**
 * Reads all geometries of a GeoJSON file as walls: lines become walls, polygons solid obstacles.
 * Polygons with holes, and those of a multi-polygon, become the walls of their sides. The property
 * {@code height} of a feature is the height of its walls, in metres or with a unit.
 */
final class GeoJsonWalls {
  private static final int MAX_LABEL = 100;

  private final Drawing drawing;
  private final PlanPoints points;
  private JsonStream json;

  GeoJsonWalls(Drawing drawing, PlanPoints points) {
    this.drawing = drawing;
    this.points = points;
  }

  void read(Path file) {
    try (JsonStream stream = JsonStream.open(file)) {
      json = stream;
      json.next();
      Feature topLevel = new Feature();
      readObject(topLevel);
      topLevel.add();
    }
  }

  /** The shapes of an object, with the labels and the height in its properties. */
  private final class Feature {
    private final List<DrawnShape> shapes = new ArrayList<>();
    private final List<Label> labels = new ArrayList<>();
    private final Place place = json.place();
    private double height = Double.POSITIVE_INFINITY;
    private boolean hasProperties;

    void add() {
      shapes.forEach(shape -> drawing.add(place, shape, new Traits(height, labels)));
    }
  }

  /** Reads an object that may be a geometry, or contain geometries. */
  private void readObject(Feature parent) {
    Feature own = new Feature();
    String[] type = {""};
    List<List<Point>> lines = new ArrayList<>();
    json.object(
        "a GeoJSON object",
        name -> {
          boolean isArray = json.token() == JsonToken.START_ARRAY;
          boolean isObject = json.token() == JsonToken.START_OBJECT;
          if (name.equals("type")) {
            type[0] = json.text();
          } else if (name.equals("id") && json.token().isScalarValue()) {
            own.labels.add(new Label(Label.ID, json.text()));
          } else if (name.equals("coordinates") && isArray) {
            Positions.read(json).forEach(line -> lines.add(line(line)));
          } else if (name.equals("properties")) {
            own.hasProperties = true;
            if (isObject) {
              json.object("properties", property -> readProperty(own, property));
            }
          } else if (isArray) {
            json.array("an array", () -> readMember(own));
          } else {
            readMember(own);
          }
        });
    addShapes(own, type[0], lines);
    if (own.hasProperties || type[0].equals("Feature")) {
      own.add();
    } else {
      parent.shapes.addAll(own.shapes);
    }
  }

  private void readMember(Feature own) {
    if (json.token() == JsonToken.START_OBJECT) {
      readObject(own);
    }
  }

  private void readProperty(Feature own, String name) {
    if (name.equals("height") && json.token() != JsonToken.VALUE_NULL) {
      own.height = drawing.height(this::height);
    } else if (json.token().isScalarValue() && json.text().length() <= MAX_LABEL) {
      own.labels.add(Label.ofProperty(name, json.text()));
    }
  }

  /** Reads a number or, as in OpenStreetMap, a text with or without a unit. */
  private double height() {
    return json.token() == JsonToken.VALUE_STRING
        ? DrawnPart.height(json.place(), json.text())
        : DrawnPart.height(json.place(), json.number("height"));
  }

  private void addShapes(Feature own, String type, List<List<Point>> lines) {
    if (type.equals("Polygon") && !lines.isEmpty()) {
      own.shapes.add(new Area(lines.get(0), lines.subList(1, lines.size()), lines.size() == 1));
    } else if (type.equals("MultiPolygon")) {
      own.shapes.addAll(areas(lines));
    } else if (type.contains("LineString")) {
      lines.forEach(line -> own.shapes.add(new DrawnShape.Line(line)));
    } else if (type.contains("Point")) {
      drawing.leaveOut("point");
    }
  }

  /** Makes areas from rings: a ring within the area before it is one of its holes. */
  private static List<DrawnShape> areas(List<List<Point>> rings) {
    List<DrawnShape> areas = new ArrayList<>();
    Area last = null;
    for (List<Point> ring : rings) {
      if (last != null && WalkableArea.holds(last.border(), ring.get(0))) {
        last.holes().add(ring);
      } else {
        last = new Area(ring, new ArrayList<>(), false);
        areas.add(last);
      }
    }
    return areas;
  }

  private List<Point> line(List<Positions.Position> positions) {
    return positions.stream()
        .map(position -> points.point(position.place(), position.x(), position.y()))
        .toList();
  }
}
