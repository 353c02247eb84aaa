package org.hificamsim.tracks.place;

import com.fasterxml.jackson.core.JsonToken;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.Place;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.data.JsonStream;
import org.hificamsim.tracks.format.Positions;

/**
 * Reads all geometries of a GeoJSON file as walls: lines become walls, polygons solid obstacles.
 * Polygons with holes, and those of a multi-polygon, become the walls of their sides. The property
 * {@code height} of a feature is the height of its walls, metres.
 */
final class GeoJsonWalls {
  private final WallCollector walls;
  private JsonStream json;

  GeoJsonWalls(WallCollector walls) {
    this.walls = walls;
  }

  void read(Path file) {
    try (JsonStream stream = JsonStream.open(file)) {
      json = stream;
      json.next();
      object();
    }
  }

  /** Reads an object that may be a geometry, or contain geometries. */
  private void object() {
    String[] type = {""};
    double[] height = {Double.NaN};
    Place[] place = {null};
    int first = walls.count();
    List<List<Point>> lines = new ArrayList<>();
    json.object(
        "a GeoJSON object",
        name -> {
          if (name.equals("type")) {
            type[0] = json.text();
          } else if (name.equals("coordinates") && json.token() == JsonToken.START_ARRAY) {
            Positions.read(json).forEach(line -> lines.add(line(line)));
          } else if (json.token() == JsonToken.START_ARRAY) {
            json.array("an array", this::member);
          } else if (!name.equals("properties")) {
            member();
          } else if (json.token() == JsonToken.START_OBJECT) {
            json.object(
                "properties",
                property -> {
                  if (property.equals("height") && json.token() != JsonToken.VALUE_NULL) {
                    place[0] = json.place();
                    height[0] = height();
                  }
                });
          }
        });
    add(type[0], lines);
    if (place[0] != null) {
      walls.raise(place[0], first, height[0]);
    }
  }

  /** Reads a number or, as in OpenStreetMap, the text of a number. */
  private double height() {
    try {
      return json.token() == JsonToken.VALUE_STRING
          ? Double.parseDouble(json.text())
          : json.number("height");
    } catch (NumberFormatException e) {
      throw json.invalid("height", "a number (m)");
    }
  }

  private void member() {
    if (json.token() == JsonToken.START_OBJECT) {
      object();
    }
  }

  private void add(String type, List<List<Point>> lines) {
    if (type.equals("Polygon") && lines.size() == 1) {
      walls.ring(lines.get(0));
    } else if (type.contains("Polygon") || type.contains("LineString")) {
      lines.forEach(walls::line);
    }
  }

  private List<Point> line(List<Positions.Position> positions) {
    return positions.stream()
        .map(position -> walls.point(position.place(), position.x(), position.y()))
        .toList();
  }
}
