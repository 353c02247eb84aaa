package org.hificamsim.runs.output;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.ToDoubleBiFunction;
import java.util.function.ToDoubleFunction;
import java.util.function.ToIntFunction;
import java.util.function.ToLongFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.file.CsvTable;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.file.Rows;
import org.hificamsim.data.CsvReader;
import org.hificamsim.data.CsvRow;
import org.hificamsim.data.CsvRows;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.output.Column.Kind;

/**
 * A table of results.
 *
 * @param <R> the type that a row is made of
 * @param file the name of the file
 * @param columns the columns in order
 */
public record Table<R>(String file, List<Column<R>> columns) {
  /** Creates a table without columns. */
  public static <R> Table<R> of(String file) {
    return new Table<>(file, List.of());
  }

  /** The same table with further columns. */
  public Table<R> with(List<Column<R>> further) {
    return new Table<>(file, Stream.concat(columns.stream(), further.stream()).toList());
  }

  private Table<R> with(String name, Kind kind, String unit, String meaning, Column.Cell<R> cell) {
    return with(List.of(new Column<>(name, kind, unit, meaning, cell)));
  }

  /** The same table with a column of texts. */
  public Table<R> texts(String name, String meaning, Function<R, String> value) {
    return with(name, Kind.TEXT, "", meaning, (row, to) -> to.add(value.apply(row)));
  }

  /** The same table with a column of 32-bit whole numbers. */
  public Table<R> ints(String name, String unit, String meaning, ToIntFunction<R> value) {
    return with(name, Kind.INT, unit, meaning, (row, to) -> to.add(value.applyAsInt(row)));
  }

  /** The same table with a column of 64-bit whole numbers. */
  public Table<R> longs(String name, String unit, String meaning, ToLongFunction<R> value) {
    return with(name, Kind.LONG, unit, meaning, (row, to) -> to.add(value.applyAsLong(row)));
  }

  /** The same table with a column of floating numbers; NaN is an empty cell. */
  public Table<R> doubles(String name, String unit, String meaning, ToDoubleFunction<R> value) {
    return with(name, Kind.DOUBLE, unit, meaning, (row, to) -> to.add(value.applyAsDouble(row)));
  }

  /** The same table with a column of a metric. */
  public Table<R> doubles(Metric metric, ToDoubleBiFunction<R, Metric> value) {
    return doubles(
        metric.label(), metric.unit(), metric.meaning(), row -> value.applyAsDouble(row, metric));
  }

  /** The same table with a column of numbers; whole ones are written without a fraction. */
  public Table<R> plain(String name, String unit, String meaning, ToDoubleFunction<R> value) {
    return with(
        name,
        Kind.DOUBLE,
        unit,
        meaning,
        (row, to) -> {
          double number = value.applyAsDouble(row);
          if (number == Math.rint(number)) {
            to.add((long) number);
          } else {
            to.add(number);
          }
        });
  }

  /** The same table with a column of a metric; whole numbers are written without a fraction. */
  public Table<R> plain(Metric metric, ToDoubleBiFunction<R, Metric> value) {
    return plain(
        metric.label(), metric.unit(), metric.meaning(), row -> value.applyAsDouble(row, metric));
  }

  /**
   * The same table with columns of an estimate and the ends of its 95% interval.
   *
   * @param ends the prefix of the names of the ends, before {@code low} and {@code high}
   */
  public Table<R> estimates(
      String name, String ends, String unit, String meaning, Function<R, Estimate> value) {
    return doubles(name, unit, meaning, row -> value.apply(row).mean())
        .doubles(
            ends + "low", unit, "the lower end of its 95% interval", row -> value.apply(row).low())
        .doubles(ends + "high", unit, "the upper end", row -> value.apply(row).high());
  }

  /** The same table with columns for an object that each row contains. */
  public <P> Table<R> with(List<Column<P>> further, Function<R, P> part) {
    return with(further.stream().map(column -> column.forPart(part)).toList());
  }

  /** The name of the file in another format, by its ending. */
  public String file(String format) {
    return file.replace(".csv", "." + format);
  }

  /** Adds a row. */
  public void add(R row, Rows to) {
    for (int i = 0; i < columns.size(); i++) { // an iterator would be allocated for each row
      columns.get(i).cell().add(row, to);
    }
    to.end();
  }

  /** Adds the whole table to a folder's files. */
  public void write(OutputFolder folder, Stream<R> rows) throws IOException {
    try (Rows out = create(folder)) {
      rows.forEach(row -> add(row, out));
    }
  }

  /** Begins the table as CSV in a folder. */
  Rows create(OutputFolder folder) throws IOException {
    String names = columns.stream().map(Column::name).collect(Collectors.joining(","));
    return new CsvTable(folder.open(file), names, ',', "\n");
  }

  /** Whether a folder has the table. */
  public boolean isIn(Path folder) {
    return Files.isRegularFile(folder.resolve(file));
  }

  /**
   * Reads the table of a folder.
   *
   * @throws org.hificamsim.core.InputException when the table is missing, broken or lacks a column
   */
  public CsvRows read(Path folder) {
    return reader(folder).readAll(columnNames());
  }

  /**
   * Reads the table of a folder row by row, so that its size does not matter.
   *
   * @param consumer receives each row in order
   * @throws org.hificamsim.core.InputException when the table is missing, broken or lacks a column
   */
  public void read(Path folder, Consumer<CsvRow> consumer) {
    try (CsvReader reader = reader(folder)) {
      reader.header(columnNames());
      reader.forEachRow(consumer);
    }
  }

  private CsvReader reader(Path folder) {
    return CsvReader.openCommaSeparated(
        new ResultFolder(folder).file(file), "a table that 'hificamsim' writes");
  }

  private List<String> columnNames() {
    return columns.stream().map(Column::name).toList();
  }
}
