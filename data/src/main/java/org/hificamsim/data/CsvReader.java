package org.hificamsim.data;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.dataformat.csv.CsvFactory;
import com.fasterxml.jackson.dataformat.csv.CsvParser;
import com.fasterxml.jackson.dataformat.csv.CsvSchema;
import java.io.BufferedInputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.TextLines;

/**
 * Reads a CSV table in UTF-8 row by row, so that a table of any size takes little memory. A file
 * whose name ends in {@code .gz} is decompressed. Empty lines are skipped.
 */
public final class CsvReader implements Closeable {
  private static final CsvFactory FACTORY =
      CsvFactory.builder().enable(CsvParser.Feature.WRAP_AS_ARRAY).build();

  /** The number of bytes within which the first line has to end for its separator to be found. */
  private static final int MAX_FIRST_LINE_BYTES = 1 << 16;

  /** The size limit of a table that is kept in memory. */
  private static final long MAX_CHARACTERS = 256L << 20;

  private final Path file;
  private final String expected;
  private final boolean verbatim;
  private final char separator;
  private final CsvParser parser;
  private final List<String> texts = new ArrayList<>();
  private long[] places = new long[16];
  private Map<String, Integer> columns = Map.of();
  private int width;

  /**
   * @param separator separator of cells; 0 for the most frequent one in the first line
   */
  private CsvReader(Path file, String expected, boolean verbatim, char separator) {
    this.file = file;
    this.expected = expected;
    this.verbatim = verbatim;
    try {
      InputStream in = new BufferedInputStream(TextLines.stream(file), MAX_FIRST_LINE_BYTES);
      this.separator = separator == 0 ? separator(in) : separator;
      parser = FACTORY.createParser(in);
      parser.setSchema(CsvSchema.emptySchema().withColumnSeparator(this.separator));
    } catch (IOException e) {
      throw unreadable(e);
    }
  }

  /**
   * Opens a table whose cells are separated by commas, semicolons or tabs, whichever is most
   * frequent in its first line. Blanks around values are removed. With semicolons, numbers may have
   * a decimal comma.
   *
   * @param expected the expected kind of table, for error messages
   * @throws InputException when it is missing or cannot be read
   */
  public static CsvReader open(Path file, String expected) {
    return new CsvReader(file, expected, false, (char) 0);
  }

  /**
   * Opens a table whose cells are separated by commas, and keeps blanks around values.
   *
   * @param expected the expected kind of table, for error messages
   * @throws InputException when it is missing or cannot be read
   */
  public static CsvReader openCommaSeparated(Path file, String expected) {
    return new CsvReader(file, expected, true, ',');
  }

  /**
   * Opens a table whose cells are separated by a given character. Blanks around values are removed.
   *
   * @param expected the expected kind of table, for error messages
   * @throws InputException when it is missing or cannot be read
   */
  public static CsvReader openSeparated(Path file, String expected, char separator) {
    return new CsvReader(file, expected, false, separator);
  }

  private static char separator(InputStream in) throws IOException {
    in.mark(MAX_FIRST_LINE_BYTES);
    byte[] start = in.readNBytes(MAX_FIRST_LINE_BYTES);
    in.reset();
    char best = ',';
    for (char candidate : new char[] {';', '\t'}) {
      best = count(start, candidate) > count(start, best) ? candidate : best;
    }
    return best;
  }

  private static int count(byte[] start, char wanted) {
    int count = 0;
    for (int i = 0; i < start.length && start[i] != '\n' && start[i] != '\r'; i++) {
      count += start[i] == wanted ? 1 : 0;
    }
    return count;
  }

  /**
   * Reads the first row; all other rows must have the same number of cells.
   *
   * @throws InputException when the table is empty
   */
  public CsvRow first() {
    CsvRow first = next();
    if (first == null) {
      throw start().error("the table is empty, expected " + expected);
    }
    width = first.count();
    return first;
  }

  /**
   * Reads the first row as the names of the columns; all other rows must have the same number of
   * cells.
   *
   * @param required names of the columns that the table must have
   * @throws InputException when the table is empty or a required column is missing
   */
  public List<String> header(List<String> required) {
    CsvRow names = first();
    columns = new HashMap<>();
    for (int i = 0; i < names.count(); i++) {
      columns.putIfAbsent(names.text(i), i);
    }
    if (!columns.keySet().containsAll(required)) {
      throw start()
          .error(
              "the columns are %s, expected %s among them",
              String.join(",", names.texts()), String.join(",", required));
    }
    return names.texts();
  }

  /**
   * Returns the next row, or null at the end.
   *
   * @throws InputException when the row is malformed or its number of cells differs from the first
   *     row
   */
  public CsvRow next() {
    do {
      if (!read()) {
        return null;
      }
    } while (texts.size() == 1 && texts.get(0).isBlank());
    CsvRow row =
        new CsvRow(
            this, columns, texts.toArray(new String[0]), Arrays.copyOf(places, texts.size()));
    if (width > 0 && row.count() != width) {
      throw row.place(0).error("the row has %s cells, expected %s".formatted(row.count(), width));
    }
    return row;
  }

  /** Reads a row into {@code texts}; returns false at the end of the table. */
  private boolean read() {
    texts.clear();
    try {
      JsonToken token = parser.nextToken();
      while (token != null && token != JsonToken.END_ARRAY) {
        if (token != JsonToken.START_ARRAY) {
          add(parser.getText(), place(parser.currentTokenLocation()));
        }
        token = parser.nextToken();
      }
      return !texts.isEmpty();
    } catch (JsonProcessingException e) {
      long place = place(e.getLocation());
      throw new InputException(
          new Place(file(), (int) (place >> Integer.SIZE), (int) place)
              .line(e.getOriginalMessage() + ", expected " + expected),
          e);
    } catch (IOException e) {
      throw unreadable(e);
    }
  }

  private void add(String text, long place) {
    if (texts.size() == places.length) {
      places = Arrays.copyOf(places, 2 * places.length);
    }
    places[texts.size()] = place;
    texts.add(verbatim ? text : text.strip());
  }

  private static long place(JsonLocation location) {
    return location == null
        ? CsvRow.place(1, 1)
        : CsvRow.place(Math.max(1, location.getLineNr()), Math.max(1, location.getColumnNr()));
  }

  /**
   * Passes each remaining row to {@code consumer}.
   *
   * @throws InputException when a row is malformed
   */
  public void forEachRow(Consumer<CsvRow> consumer) {
    for (CsvRow row = next(); row != null; row = next()) {
      consumer.accept(row);
    }
  }

  /**
   * Reads the whole table and closes it.
   *
   * @param required names of the columns that the table must have
   * @throws InputException when a row is malformed or the table is larger than 256 MiB
   */
  public CsvRows readAll(List<String> required) {
    try (this) {
      List<String> names = header(required);
      List<CsvRow> rows = new ArrayList<>();
      forEachRow(
          row -> {
            rows.add(row);
            requireFitsMemory();
          });
      return new CsvRows(file, names, rows);
    }
  }

  private void requireFitsMemory() {
    if (parser.currentLocation().getCharOffset() > MAX_CHARACTERS) {
      throw start().error("the table is too big, expected at most 256 MiB");
    }
  }

  String file() {
    return file.toString();
  }

  /** Returns the text of a number with a decimal point instead of a decimal comma. */
  String number(String text) {
    return separator == ';' ? text.replace(',', '.') : text;
  }

  private Place start() {
    return new Place(file(), 1, 1);
  }

  private InputException unreadable(IOException e) {
    return new InputException(
        start().line("cannot be read (" + e.getMessage() + "), expected " + expected), e);
  }

  @Override
  public void close() {
    try {
      parser.close();
    } catch (IOException e) {
      throw unreadable(e);
    }
  }
}
