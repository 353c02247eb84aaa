package org.hificamsim.profiling.dataset;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.dataformat.csv.CsvFactory;
import com.fasterxml.jackson.dataformat.csv.CsvParser;
import com.fasterxml.jackson.dataformat.csv.CsvSchema;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;

/**
 * A CSV table whose cells know their place: between commas, or as spreadsheets write it, between
 * semicolons and with a byte order mark.
 *
 * @param columns of the header line
 * @param rows by column name
 */
public record CsvRows(String file, List<String> columns, List<Map<String, Cell>> rows) {
  private static final long MAX_BYTES = 256L << 20;
  private static final String BYTE_ORDER_MARK = "\uFEFF";
  private static final char SEMICOLON = ';';

  /**
   * A cell's text without surrounding blanks, and where it stands.
   *
   * @param decimalComma whether numbers may have a comma, as in tables with semicolons
   */
  public record Cell(Place place, String text, boolean decimalComma) {
    private boolean isEmpty() {
      return text.isEmpty();
    }

    /** The fault of this cell: what it is, its value and what was expected. */
    public InputException error(String column, String expected) {
      String shown = text.length() <= 60 ? text : text.substring(0, 60) + "...";
      return place.error(column + " is '" + shown + "', expected " + expected);
    }

    /** The number it holds, finite and in [least, most]. */
    public double number(String column, double least, double most, String expected) {
      try {
        double value = Double.parseDouble(decimalComma ? text.replace(',', '.') : text);
        if (value >= least && value <= most) {
          return value;
        }
      } catch (NumberFormatException e) {
        // reported below
      }
      throw error(column, expected);
    }
  }

  /**
   * Reads a table.
   *
   * @throws InputException when it is no table, or lacks a column or a cell
   */
  public static CsvRows read(Path file, List<String> required) {
    String name = file.toString();
    List<List<Cell>> lines = lines(file, name);
    if (lines.isEmpty()) {
      throw new Place(name, 1, 1).error("the table is empty, expected " + required);
    }
    List<String> columns = lines.get(0).stream().map(Cell::text).toList();
    for (String column : required) {
      if (!columns.contains(column)) {
        throw new Place(name, 1, 1)
            .error("column '" + column + "' is missing, expected " + String.join(",", required));
      }
    }
    List<Map<String, Cell>> rows = new ArrayList<>();
    for (List<Cell> line : lines.subList(1, lines.size())) {
      rows.add(row(columns, line));
    }
    return new CsvRows(name, columns, rows);
  }

  /** A text as a cell that reads back from a table between commas or semicolons. */
  public static String quoted(String text) {
    return text.matches("[^,;\"\\n\\r]*") ? text : '"' + text.replace("\"", "\"\"") + '"';
  }

  private static Map<String, Cell> row(List<String> columns, List<Cell> line) {
    if (line.size() != columns.size()) {
      throw line.get(0)
          .place()
          .error("the row has %s cells, expected %s".formatted(line.size(), columns.size()));
    }
    Map<String, Cell> row = new LinkedHashMap<>();
    for (int i = 0; i < columns.size(); i++) {
      row.put(columns.get(i), line.get(i));
    }
    return row;
  }

  private static List<List<Cell>> lines(Path file, String name) {
    try {
      if (Files.size(file) > MAX_BYTES) {
        throw new Place(name, 1, 1).error("the table is too big, expected at most 256 MiB");
      }
      String text = Files.readString(file);
      text = text.startsWith(BYTE_ORDER_MARK) ? text.substring(1) : text;
      char separator = separator(text);
      try (CsvParser parser = new CsvFactory().createParser(text)) {
        parser.enable(CsvParser.Feature.WRAP_AS_ARRAY);
        parser.enable(CsvParser.Feature.SKIP_EMPTY_LINES);
        parser.setSchema(CsvSchema.emptySchema().withColumnSeparator(separator));
        return lines(parser, name, separator == SEMICOLON);
      }
    } catch (NoSuchFileException e) {
      throw new InputException(name + ": no such file, expected a data set's table", e);
    } catch (JsonProcessingException e) {
      throw new Place(name, e.getLocation().getLineNr(), e.getLocation().getColumnNr())
          .error("no valid CSV, expected cells between commas: " + e.getOriginalMessage());
    } catch (CharacterCodingException e) {
      throw new InputException(name + ":1:1: no text, expected a table in UTF-8", e);
    } catch (IOException | UncheckedIOException e) {
      throw new InputException(name + ": cannot be read, expected a table: " + e.getMessage(), e);
    }
  }

  /** What stands between the cells of the header: a semicolon where a spreadsheet put some. */
  private static char separator(String text) {
    String header = text.lines().findFirst().orElse("");
    return header.indexOf(',') < 0 && header.indexOf(SEMICOLON) >= 0 ? SEMICOLON : ',';
  }

  private static List<List<Cell>> lines(CsvParser parser, String name, boolean decimalComma)
      throws IOException {
    List<List<Cell>> lines = new ArrayList<>();
    List<Cell> line = List.of();
    for (JsonToken token = parser.nextToken(); token != null; token = parser.nextToken()) {
      if (token == JsonToken.START_ARRAY) {
        line = new ArrayList<>();
        lines.add(line);
      } else if (token == JsonToken.VALUE_STRING) {
        int row = parser.currentTokenLocation().getLineNr();
        int column = Math.max(1, parser.currentTokenLocation().getColumnNr());
        line.add(new Cell(new Place(name, row, column), parser.getText().strip(), decimalComma));
      }
    }
    lines.removeIf(cells -> cells.size() <= 1 && cells.stream().allMatch(Cell::isEmpty));
    return lines;
  }
}
