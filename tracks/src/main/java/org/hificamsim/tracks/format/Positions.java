package org.hificamsim.tracks.format;

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

  private final JsonStream json;
  private final List<List<Position>> lines = new ArrayList<>();

  private Positions(JsonStream json) {
    this.json = json;
  }

  /**
   * Reads the array that has been begun: each innermost array of positions by itself, a position
   * alone as an array of one.
   *
   * @throws org.hificamsim.core.InputException with the place, when it holds anything else
   */
  public static List<List<Position>> read(JsonStream json) {
    Positions positions = new Positions(json);
    List<Position> alone = new ArrayList<>();
    positions.array(alone);
    positions.add(alone);
    return positions.lines;
  }

  private void add(List<Position> line) {
    if (!line.isEmpty()) {
      lines.add(line);
    }
  }

  /** Reads a position into the list that it belongs to, or the arrays in an array. */
  private void array(List<Position> above) {
    Place place = json.place();
    List<Position> own = new ArrayList<>();
    List<Double> numbers = new ArrayList<>();
    json.array(
        "arrays of coordinates",
        () -> {
          if (numbers.isEmpty() && json.isBegun()) {
            array(own);
          } else {
            numbers.add(json.coordinate("a coordinate"));
          }
        });
    if (numbers.size() == 1 || (!numbers.isEmpty() && !own.isEmpty())) {
      throw place.error("expected two coordinates, or arrays of coordinates");
    }
    if (!numbers.isEmpty()) {
      above.add(new Position(place, numbers.get(0), numbers.get(1)));
    }
    add(own);
  }
}
