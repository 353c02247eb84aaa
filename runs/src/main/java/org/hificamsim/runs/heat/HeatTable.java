package org.hificamsim.runs.heat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.data.CsvRow;
import org.hificamsim.data.CsvRows;
import org.hificamsim.runs.heat.HeatMap.Place;
import org.hificamsim.runs.output.CsvTable;
import org.hificamsim.runs.output.Table;

/** A heat map as a table, a row per cell: written, and read again. */
public final class HeatTable {
  private static final double DIGITS = 1e6; // shares and metres to a millionth
  private static final double ROUNDING = 1e-5;

  private HeatTable() {}

  /** Adds {@code heatmap.csv}. */
  public static void write(OutputFolder folder, HeatMap map) throws IOException {
    try (CsvTable table = Table.HEATMAP.create(folder)) {
      for (int cell = 0; cell < map.cells().count(); cell++) {
        table.row(row(map.cells(), cell, map.places().get(cell)));
      }
    }
  }

  private static Object[] row(Cells cells, int cell, Place place) {
    return new Object[] {
      cell % cells.columns(),
      cell / cells.columns(),
      rounded(cells.x(cell)),
      rounded(cells.y(cell)),
      rounded(cells.width()),
      rounded(cells.height()),
      rounded(place.meanK()),
      rounded(place.covered0()),
      rounded(place.covered1()),
      rounded(place.coveredK()),
      place.visits(),
      rounded(place.visitsMeanK()),
      rounded(place.visitsCovered0())
    };
  }

  private static double rounded(double number) {
    return Double.isNaN(number) ? number : Math.round(number * DIGITS) / DIGITS;
  }

  /**
   * Reads the table of a folder.
   *
   * @param field that the cells belong to
   * @throws InputException when it is broken, or of another field
   */
  public static HeatMap read(Path folder, Field field) throws IOException {
    CsvRows table = Table.HEATMAP.read(folder);
    Cells cells = cells(table, field);
    List<Place> places = new ArrayList<>();
    for (CsvRow row : table.rows()) {
      check(row, "x", cells.x(places.size()), cells.field().width());
      check(row, "y", cells.y(places.size()), cells.field().height());
      places.add(place(row));
    }
    return new HeatMap(cells, places);
  }

  private static Cells cells(CsvRows table, Field field) {
    int count = table.rows().size();
    int columns = count == 0 ? 0 : 1 + (int) table.rows().get(count - 1).numberOrNaN("column");
    int rows = count == 0 ? 0 : 1 + (int) table.rows().get(count - 1).numberOrNaN("row");
    boolean whole = columns > 0 && rows > 0 && columns <= Cells.MAX && rows <= Cells.MAX;
    if (!whole || (long) columns * rows != count) {
      throw new InputException(
          "%s:%s:1: %s rows, expected one for each cell of a rectangle"
              .formatted(table.file(), count + 1, count));
    }
    return new Cells(field, columns, rows);
  }

  private static void check(CsvRow row, String column, double expected, double side) {
    double found = row.numberOrNaN(column);
    if (!(Math.abs(found - expected) <= ROUNDING * Math.max(1, side))) {
      throw row.place(column)
          .error(
              "%s is %s, expected %s, as the field of this run is cut into cells"
                  .formatted(column, found, rounded(expected)));
    }
  }

  private static Place place(CsvRow row) {
    return new Place(
        row.numberOrNaN("mean_k"),
        row.numberOrNaN("covered_0"),
        row.numberOrNaN("covered_1"),
        row.numberOrNaN("covered_k"),
        (long) row.numberOrNaN("visits"),
        row.numberOrNaN("visits_mean_k"),
        row.numberOrNaN("visits_covered_0"));
  }
}
