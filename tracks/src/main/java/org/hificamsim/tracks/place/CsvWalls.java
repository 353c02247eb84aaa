package org.hificamsim.tracks.place;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.hificamsim.core.Place;
import org.hificamsim.data.CsvReader;
import org.hificamsim.data.CsvRow;
import org.hificamsim.tracks.place.DrawnPart.Traits;

/**
 * Reads a table with a column of geometries in well-known text, as QGIS and PostGIS write it. A
 * column {@code height} is the height of walls; the others are names by which rows can be chosen.
 */
final class CsvWalls {
  private static final Set<String> GEOMETRIES =
      Set.of("wkt", "geom", "geometry", "the_geom", "wkt_geom", "shape");

  private static final String HEIGHT = "height";
  private static final int MAX_LABEL = 100;

  private final Drawing drawing;
  private final WktShapes shapes;
  private List<String> names = List.of();

  CsvWalls(Drawing drawing, WktShapes shapes) {
    this.drawing = drawing;
    this.shapes = shapes;
  }

  void read(Path file) {
    try (CsvReader table = CsvReader.open(file, "a table with a column wkt")) {
      names = table.header(List.of());
      int geometry = geometry(file);
      table.forEachRow(row -> add(row, geometry));
    }
  }

  private int geometry(Path file) {
    for (int column = 0; column < names.size(); column++) {
      if (GEOMETRIES.contains(names.get(column).toLowerCase(Locale.ROOT))) {
        return column;
      }
    }
    throw new Place(file.toString(), 1, 1)
        .error(
            "the columns are %s, expected wkt or geometry, with well-known text, among them",
            String.join(", ", names));
  }

  private void add(CsvRow row, int geometry) {
    if (row.text(geometry).isBlank()) {
      drawing.leaveOut("row without a geometry");
      return;
    }
    List<Label> labels = new ArrayList<>();
    double height = Double.POSITIVE_INFINITY;
    for (int column = 0; column < names.size(); column++) {
      String text = row.text(column);
      Place place = row.place(column);
      if (names.get(column).equalsIgnoreCase(HEIGHT) && !text.isBlank()) {
        height = drawing.height(() -> DrawnPart.height(place, text));
      } else if (column != geometry && !text.isBlank() && text.length() <= MAX_LABEL) {
        labels.add(Label.ofProperty(names.get(column), text));
      }
    }
    shapes.add(row.place(geometry), row.text(geometry), new Traits(height, labels));
  }
}
