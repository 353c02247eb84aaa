package org.hificamsim.tracks.place;

import com.fasterxml.jackson.core.JsonToken;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.data.JsonStream;
import org.hificamsim.tracks.format.Positions;

/**
 * The geometries of a GeoJSON file, wherever they stand: lines are walls, polygons are solid. A
 * polygon with holes, and one of several in one geometry, is its sides alone.
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
      if (json.next() != JsonToken.START_OBJECT) {
        throw json.error("expected a GeoJSON object");
      }
      object();
    }
  }

  /** An object that may be a geometry, or hold some. */
  private void object() {
    String type = "";
    List<List<Point>> lines = new ArrayList<>();
    while (json.nextProperty()) {
      String name = json.text();
      JsonToken token = json.next();
      if (name.equals("type")) {
        type = json.text();
      } else if (name.equals("coordinates") && token == JsonToken.START_ARRAY) {
        Positions.read(json).forEach(line -> lines.add(line(line)));
      } else if (token == JsonToken.START_OBJECT && !name.equals("properties")) {
        object();
      } else if (token == JsonToken.START_ARRAY) {
        array();
      } else {
        json.skip();
      }
    }
    add(type, lines);
  }

  private void array() {
    JsonToken token = json.next();
    while (token != JsonToken.END_ARRAY) {
      if (token == JsonToken.START_OBJECT) {
        object();
      } else {
        json.skip();
      }
      token = json.next();
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
    return positions.stream().map(one -> walls.point(one.place(), one.x(), one.y())).toList();
  }
}
