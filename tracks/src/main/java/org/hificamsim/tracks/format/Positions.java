package org.hificamsim.tracks.format;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.Place;
import org.hificamsim.data.JsonStream;

/** Reads the {@code coordinates} of a GeoJSON geometry. */
public final class Positions {
  /**
   * A position; a third coordinate is ignored.
   *
   * @param x longitude, unless the file has another unit
   * @param y latitude, unless the file has another unit
   */
  public record Position(Place place, double x, double y) {}

  private final JsonStream json;
  private final List<List<Position>> lines = new ArrayList<>();

  private Positions(JsonStream json) {
    this.json = json;
  }

  /**
   * Reads the array that has been begun. Each innermost array of positions becomes a list; a single
   * position becomes a list of one.
   *
   * @throws org.hificamsim.core.InputException with the place, if the array has anything else
   */
  public static List<List<Position>> read(JsonStream json) {
    Positions positions = new Positions(json);
    List<Position> single = new ArrayList<>();
    positions.readArray(single);
    positions.add(single);
    return positions.lines;
  }

  private void add(List<Position> line) {
    if (!line.isEmpty()) {
      lines.add(line);
    }
  }

  /** Reads an array: a position, which is added to a list, or an array of arrays. */
  private void readArray(List<Position> parent) {
    Place place = json.place();
    List<Position> children = new ArrayList<>();
    List<Double> numbers = new ArrayList<>();
    json.array(
        "arrays of coordinates",
        () -> {
          if (numbers.isEmpty() && json.isBegun()) {
            readArray(children);
          } else {
            numbers.add(json.coordinate("a coordinate"));
          }
        });
    if (numbers.size() == 1 || (!numbers.isEmpty() && !children.isEmpty())) {
      throw place.error("expected two coordinates, or arrays of coordinates");
    }
    if (!numbers.isEmpty()) {
      parent.add(new Position(place, numbers.get(0), numbers.get(1)));
    }
    add(children);
  }
}
