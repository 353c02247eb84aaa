package org.hificamsim.runs.heat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.runs.heat.HeatMap.Place;
import org.hificamsim.runs.output.Column;
import org.hificamsim.runs.output.ResultFolder;
import org.hificamsim.runs.output.Table;
import org.hificamsim.runs.output.TableFile;

/** A heat map as a table, a row per cell: written, and read again. */
public final class HeatTable {
  private static final double DIGITS = 1e6; // shares and metres to a millionth
  private static final double ROUNDING = 1e-5;

  /** A cell, and how it was covered. */
  record Row(Cells cells, int cell, Place place) {}

  /** A row per cell of the field, over all steps of all repeats. */
  public static final Table<Row> TABLE =
      Table.<Row>of(ResultFolder.HEATMAP)
          .with(
              Column.ofInt(
                  "column", "", "from the left, from 0", row -> row.cell % row.cells.columns()),
              Column.ofInt("row", "", "from below, from 0", row -> row.cell / row.cells.columns()),
              rounded("x", "m", "its middle", row -> row.cells.x(row.cell)),
              rounded("y", "m", "its middle", row -> row.cells.y(row.cell)),
              rounded("width", "m", "how wide it is", row -> row.cells.width()),
              rounded("height", "m", "how high it is", row -> row.cells.height()),
              rounded(
                  "mean_k",
                  "cameras",
                  "that would detect a target of the usual size in the middle, mean; empty, as the"
                      + " next three, where a solid obstacle stands",
                  row -> row.place.meanK()),
              rounded(
                  "covered_0",
                  "share of steps",
                  "in which no camera would",
                  row -> row.place.covered0()),
              rounded(
                  "covered_1",
                  "share of steps",
                  "in which exactly one camera would",
                  row -> row.place.covered1()),
              rounded(
                  "covered_k",
                  "share of steps",
                  "in which two or more cameras would",
                  row -> row.place.coveredK()),
              Column.ofLong(
                  "visits",
                  "targets",
                  "in the cell, summed over the steps",
                  row -> row.place.visits()),
              rounded(
                  "visits_mean_k",
                  "cameras",
                  "that detected these targets, mean; empty without a visit",
                  row -> row.place.visitsMeanK()),
              rounded(
                  "visits_covered_0",
                  "share of visits",
                  "that no camera detected; empty without a visit",
                  row -> row.place.visitsCovered0()));

  private HeatTable() {}

  /** Adds {@code heatmap.csv}. */
  public static void write(OutputFolder folder, HeatMap map) throws IOException {
    TABLE.write(
        folder,
        IntStream.range(0, map.places().size())
            .mapToObj(cell -> new Row(map.cells(), cell, map.places().get(cell))));
  }

  private static Column<Row> rounded(
      String name, String unit, String meaning, ToDoubleFunction<Row> value) {
    return Column.ofDouble(name, unit, meaning, row -> rounded(value.applyAsDouble(row)));
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
    TableFile table = TABLE.read(folder);
    Cells cells = cells(table, field);
    List<Place> places = new ArrayList<>();
    for (int row = 0; row < table.rows().size(); row++) {
      check(table, row, cells);
      places.add(place(table, row));
    }
    return new HeatMap(cells, places);
  }

  private static Cells cells(TableFile table, Field field) {
    int last = table.rows().size() - 1;
    int columns = last < 0 ? 0 : 1 + (int) table.number(last, "column");
    int rows = last < 0 ? 0 : 1 + (int) table.number(last, "row");
    boolean whole = columns > 0 && rows > 0 && columns <= Cells.MAX && rows <= Cells.MAX;
    if (!whole || (long) columns * rows != table.rows().size()) {
      throw new InputException(
          "%s:%s:1: %s rows, expected one for each cell of a rectangle"
              .formatted(table.file(), last + 2, last + 1));
    }
    return new Cells(field, columns, rows);
  }

  private static void check(TableFile table, int row, Cells cells) {
    check(table, row, "x", cells.x(row), cells.field().width());
    check(table, row, "y", cells.y(row), cells.field().height());
  }

  private static void check(TableFile table, int row, String column, double expected, double side) {
    double found = table.number(row, column);
    if (!(Math.abs(found - expected) <= ROUNDING * Math.max(1, side))) {
      throw new InputException(
          "%s:%s:%s: %s is %s, expected %s, as the field of this run is cut into cells"
              .formatted(
                  table.file(),
                  table.line(row),
                  1 + table.columns().indexOf(column),
                  column,
                  found,
                  rounded(expected)));
    }
  }

  private static Place place(TableFile table, int row) {
    return new Place(
        table.number(row, "mean_k"),
        table.number(row, "covered_0"),
        table.number(row, "covered_1"),
        table.number(row, "covered_k"),
        (long) table.number(row, "visits"),
        table.number(row, "visits_mean_k"),
        table.number(row, "visits_covered_0"));
  }
}
