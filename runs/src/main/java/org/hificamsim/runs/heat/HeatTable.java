package org.hificamsim.runs.heat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.data.CsvRow;
import org.hificamsim.data.CsvRows;
import org.hificamsim.runs.cells.FieldCells;
import org.hificamsim.runs.heat.HeatMap.Place;
import org.hificamsim.runs.output.ResultFolder;
import org.hificamsim.runs.output.Table;

/** Writes and reads a heat map as a table with a row per cell. */
public final class HeatTable {
  /** The number of parts of a unit to which shares and metres are rounded. */
  private static final double MILLIONTHS = 1e6;

  private static final double ROUNDING = 1e-5;

  /** A cell with its coverage. */
  record Row(FieldCells cells, int cell, Place place) {}

  /** A table with a row for each cell of the field, over all steps of all repeats. */
  public static final Table<Row> TABLE =
      Table.<Row>of(ResultFolder.HEATMAP)
          .ints("column", "", "from the left, from 0", row -> row.cell % row.cells.columns())
          .ints("row", "", "from below, from 0", row -> row.cell / row.cells.columns())
          .doubles("x", "m", "centre of the cell", row -> rounded(row.cells.x(row.cell)))
          .doubles("y", "m", "centre of the cell", row -> rounded(row.cells.y(row.cell)))
          .doubles("width", "m", "width of the cell", row -> rounded(row.cells.width()))
          .doubles("height", "m", "height of the cell", row -> rounded(row.cells.height()))
          .doubles(
              "mean_k",
              "cameras",
              "that would detect a target of the usual size in the middle, mean; empty, as the next"
                  + " three, where a solid obstacle stands",
              row -> rounded(row.place.meanK()))
          .doubles(
              "covered_0",
              "share of steps",
              "in which no camera would",
              row -> rounded(row.place.covered0()))
          .doubles(
              "covered_1",
              "share of steps",
              "in which exactly one camera would",
              row -> rounded(row.place.covered1()))
          .doubles(
              "covered_k",
              "share of steps",
              "in which two or more cameras would",
              row -> rounded(row.place.coveredK()))
          .longs(
              "visits", "targets", "in the cell, summed over the steps", row -> row.place.visits())
          .doubles(
              "visits_mean_k",
              "cameras",
              "that detected these targets, mean; empty without a visit",
              row -> rounded(row.place.visitsMeanK()))
          .doubles(
              "visits_covered_0",
              "share of visits",
              "that no camera detected; empty without a visit",
              row -> rounded(row.place.visitsCovered0()));

  private HeatTable() {}

  /** Adds {@code heatmap.csv} to a folder's files. */
  public static void write(OutputFolder folder, HeatMap map) throws IOException {
    TABLE.write(
        folder,
        IntStream.range(0, map.places().size())
            .mapToObj(cell -> new Row(map.cells(), cell, map.places().get(cell))));
  }

  private static double rounded(double number) {
    return Double.isNaN(number) ? number : Math.round(number * MILLIONTHS) / MILLIONTHS;
  }

  /**
   * Reads the table of a folder.
   *
   * @param field the field of the cells
   * @throws InputException when the table is broken, or of another field
   */
  public static HeatMap read(Path folder, Field field) throws IOException {
    CsvRows table = TABLE.read(folder);
    FieldCells cells = cells(table, field);
    List<Place> places = new ArrayList<>();
    for (CsvRow row : table.rows()) {
      check(row, "x", cells.x(places.size()), cells.field().width());
      check(row, "y", cells.y(places.size()), cells.field().height());
      places.add(place(row));
    }
    return new HeatMap(cells, places);
  }

  private static FieldCells cells(CsvRows table, Field field) {
    int count = table.rows().size();
    int columns = count == 0 ? 0 : 1 + (int) table.rows().get(count - 1).numberOrNaN("column");
    int rows = count == 0 ? 0 : 1 + (int) table.rows().get(count - 1).numberOrNaN("row");
    boolean isWithinLimits =
        columns > 0 && rows > 0 && columns <= FieldCells.MAX && rows <= FieldCells.MAX;
    if (!isWithinLimits || (long) columns * rows != count) {
      throw InputException.of(
          "%s:%s:1: %s rows, expected one for each cell of a rectangle",
          table.file(), count + 1, count);
    }
    return new FieldCells(field, columns, rows);
  }

  private static void check(CsvRow row, String column, double expected, double side) {
    double found = row.numberOrNaN(column);
    if (!(Math.abs(found - expected) <= ROUNDING * Math.max(1, side))) {
      throw row.place(column)
          .error(
              "%s is %s, expected %s, as the field of this run is cut into cells",
              column, found, rounded(expected));
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
