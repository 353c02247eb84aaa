package org.hificamsim.runs.output;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.MappingIterator;
import com.fasterxml.jackson.dataformat.csv.CsvMapper;
import com.fasterxml.jackson.dataformat.csv.CsvParser;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.GZIPInputStream;
import org.hificamsim.core.InputException;

/**
 * A CSV file as text: the cells of a page are those of the table.
 *
 * @param file where it was
 * @param columns the header
 * @param rows each as long as the header
 */
public record TableFile(Path file, List<String> columns, List<String[]> rows) {
  private static final CsvMapper MAPPER =
      CsvMapper.builder().enable(CsvParser.Feature.WRAP_AS_ARRAY).build();

  /**
   * Reads a table, compressed if the name ends in {@code .gz}.
   *
   * @param expected columns that it must have
   * @throws InputException when it is broken or has other columns
   */
  static TableFile read(Path file, List<String> expected) throws IOException {
    List<String[]> rows = new ArrayList<>();
    try (Reader reader = reader(file);
        MappingIterator<String[]> all = MAPPER.readerFor(String[].class).readValues(reader)) {
      while (all.hasNext()) {
        rows.add(all.next());
      }
    } catch (JsonProcessingException e) {
      throw new InputException(
          "%s:%s:%s: %s, expected a table that 'hificamsim' writes"
              .formatted(
                  file,
                  e.getLocation().getLineNr(),
                  e.getLocation().getColumnNr(),
                  e.getOriginalMessage()),
          e);
    }
    List<String> columns = rows.isEmpty() ? List.of() : List.of(rows.remove(0));
    TableFile table = new TableFile(file, columns, rows);
    table.check(expected);
    return table;
  }

  private static Reader reader(Path file) throws IOException {
    return file.toString().endsWith(".gz")
        ? new BufferedReader(
            new InputStreamReader(
                new GZIPInputStream(Files.newInputStream(file)), StandardCharsets.UTF_8))
        : Files.newBufferedReader(file);
  }

  private void check(List<String> expected) {
    if (!columns.containsAll(expected)) {
      throw new InputException(
          "%s:1:1: the columns are %s, expected %s among them"
              .formatted(file, String.join(",", columns), String.join(",", expected)));
    }
    for (int row = 0; row < rows.size(); row++) {
      if (rows.get(row).length != columns.size()) {
        throw new InputException(
            "%s:%s:1: %s values, expected %s"
                .formatted(file, line(row), rows.get(row).length, columns.size()));
      }
    }
  }

  /** The text in a column. */
  public String text(int row, String column) {
    return rows.get(row)[columns.indexOf(column)];
  }

  /** The scenario, detection and policy of a row. */
  public List<String> caseOf(int row) {
    return List.of(text(row, "scenario"), text(row, "detection"), text(row, "policy"));
  }

  /**
   * The number in a column; NaN where it is empty.
   *
   * @throws InputException when it is none
   */
  public double number(int row, String column) {
    String text = text(row, column);
    try {
      return text.isEmpty() ? Double.NaN : Double.parseDouble(text);
    } catch (NumberFormatException e) {
      throw new InputException(
          "%s:%s:%s: %s is '%s', expected a number"
              .formatted(file, line(row), columns.indexOf(column) + 1, column, text),
          e);
    }
  }

  /** The line of a row, from 1, as long as no value holds a line end. */
  public int line(int row) {
    return row + 2;
  }
}
