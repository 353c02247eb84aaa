package org.hificamsim.tracks.format;

import com.fasterxml.jackson.core.JsonToken;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.Place;
import org.hificamsim.data.JsonStream;

/** The {@code coordinates} of a GeoJSON geometry. */
public final class Positions {
  /**
   * A position; a height behind it is left out.
   *
   * @param x the longitude, as a rule
   * @param y the latitude
   */
  public record Position(Place place, double x, double y) {}

  private Positions() {}

  /**
   * Reads the array that has been begun: each innermost array of positions by itself, a position
   * alone as an array of one.
   *
   * @throws org.hificamsim.core.InputException with the place, when it holds anything else
   */
  public static List<List<Position>> read(JsonStream json) {
    List<List<Position>> lines = new ArrayList<>();
    Position alone = array(json, lines);
    if (alone != null) {
      lines.add(List.of(alone));
    }
    return lines;
  }

  /** A position, or null where the array holds arrays. */
  private static Position array(JsonStream json, List<List<Position>> lines) {
    Place place = json.place();
    JsonToken token = json.next();
    if (token != JsonToken.START_ARRAY && token != JsonToken.END_ARRAY) {
      return position(json, place);
    }
    List<Position> own = new ArrayList<>();
    while (token == JsonToken.START_ARRAY) {
      Position position = array(json, lines);
      if (position != null) {
        own.add(position);
      }
      token = json.next();
    }
    if (token != JsonToken.END_ARRAY) {
      throw json.error("expected arrays of coordinates");
    }
    if (!own.isEmpty()) {
      lines.add(own);
    }
    return null;
  }

  private static Position position(JsonStream json, Place place) {
    double x = json.coordinate("a coordinate");
    json.next();
    double y = json.coordinate("a coordinate");
    while (json.next() != JsonToken.END_ARRAY) {
      json.number("a coordinate");
    }
    return new Position(place, x, y);
  }
}
