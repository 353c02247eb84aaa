package org.hificamsim.runs.output;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.MappingIterator;
import com.fasterxml.jackson.dataformat.csv.CsvMapper;
import com.fasterxml.jackson.dataformat.csv.CsvParser;
import java.io.BufferedReader;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.zip.GZIPInputStream;
import java.util.zip.ZipException;
import org.hificamsim.core.InputException;

/**
 * A CSV file as text, or a block of its rows: the cells of a page are those of the table.
 *
 * @param file where it was
 * @param columns the header
 * @param rows each as long as the header
 * @param first the number of the first row, from 0
 */
public record TableFile(Path file, List<String> columns, List<String[]> rows, long first) {
  private static final CsvMapper MAPPER =
      CsvMapper.builder().enable(CsvParser.Feature.WRAP_AS_ARRAY).build();

  /**
   * Reads a table, whatever its columns.
   *
   * @throws InputException when it is broken
   */
  public static TableFile read(Path file) throws IOException {
    return read(file, List.of());
  }

  /**
   * Reads a table, compressed if the name ends in {@code .gz}.
   *
   * @param expected columns that it must have
   * @throws InputException when it is broken or has other columns
   */
  static TableFile read(Path file, List<String> expected) throws IOException {
    List<TableFile> whole = new ArrayList<>();
    read(file, expected, Integer.MAX_VALUE, whole::add);
    return whole.get(0);
  }

  /**
   * Reads a table that may be too large to hold at once.
   *
   * @param size most rows of a block
   * @param taker takes each block in order, at least one, which is empty where there are no rows
   */
  static void read(Path file, List<String> expected, int size, Consumer<TableFile> taker)
      throws IOException {
    try (Reader reader = reader(file);
        MappingIterator<String[]> all = MAPPER.readerFor(String[].class).readValues(reader)) {
      List<String> columns = all.hasNextValue() ? List.of(all.nextValue()) : List.of();
      long first = 0;
      do {
        TableFile block = new TableFile(file, columns, rows(all, size), first);
        block.check(expected);
        taker.accept(block);
        first += block.rows.size();
      } while (all.hasNextValue());
    } catch (JsonProcessingException e) {
      JsonLocation place = e.getLocation();
      throw broken(
          file,
          place == null ? "" : ":" + place.getLineNr() + ":" + place.getColumnNr(),
          e.getOriginalMessage(),
          e);
    } catch (ZipException | EOFException | CharacterCodingException e) {
      throw broken(file, "", e.getMessage(), e);
    }
  }

  private static List<String[]> rows(MappingIterator<String[]> all, int size) throws IOException {
    List<String[]> rows = new ArrayList<>();
    while (rows.size() < size && all.hasNextValue()) {
      rows.add(all.nextValue());
    }
    return rows;
  }

  private static InputException broken(Path file, String place, String what, IOException cause) {
    return new InputException(
        file + place + ": " + what + ", expected a table that 'hificamsim' writes", cause);
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
  public long line(int row) {
    return first + row + 2;
  }
}
