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
 * Reads a CSV table (UTF-8; unpacked where its name ends in {@code .gz}) row by row, so that a
 * table of any size takes little memory. Empty lines are left out.
 */
public final class CsvReader implements Closeable {
  private static final CsvFactory FACTORY =
      CsvFactory.builder().enable(CsvParser.Feature.WRAP_AS_ARRAY).build();
  private static final int FIRST_LINE = 1 << 16; // bytes in which a separator is looked for
  private static final long MAX_CHARACTERS = 256L << 20; // of a table that is read as a whole

  private final Path file;
  private final String expected;
  private final boolean plain;
  private final char separator;
  private final CsvParser parser;
  private final List<String> texts = new ArrayList<>();
  private long[] places = new long[16];
  private Map<String, Integer> columns = Map.of();
  private int width;

  private CsvReader(Path file, String expected, boolean plain) {
    this.file = file;
    this.expected = expected;
    this.plain = plain;
    try {
      InputStream in = new BufferedInputStream(TextLines.stream(file), FIRST_LINE);
      separator = plain ? ',' : separator(in);
      parser = FACTORY.createParser(in);
      parser.setSchema(CsvSchema.emptySchema().withColumnSeparator(separator));
    } catch (IOException e) {
      throw unreadable(e);
    }
  }

  /**
   * Opens a table from anywhere: between commas, semicolons or tabs, whichever its first line has
   * most of. Blanks around a value do not count; between semicolons numbers may have a decimal
   * comma.
   *
   * @param expected what kind of table it has to be, in error lines
   * @throws InputException when it is missing or cannot be read
   */
  public static CsvReader open(Path file, String expected) {
    return new CsvReader(file, expected, false);
  }

  /**
   * Opens a table between commas, whose values are taken as they are.
   *
   * @param expected what kind of table it has to be, in error lines
   * @throws InputException when it is missing or cannot be read
   */
  public static CsvReader betweenCommas(Path file, String expected) {
    return new CsvReader(file, expected, true);
  }

  private static char separator(InputStream in) throws IOException {
    in.mark(FIRST_LINE);
    byte[] start = in.readNBytes(FIRST_LINE);
    in.reset();
    char best = ',';
    for (char one : new char[] {';', '\t'}) {
      best = count(start, one) > count(start, best) ? one : best;
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
   * Reads the first row; all others must have as many cells then.
   *
   * @throws InputException when there is none
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
   * Reads the first row as the names of the columns; all others must have as many cells then.
   *
   * @param required names that have to be among them
   * @throws InputException when there is no such row, or one is missing
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
   * The next row, or null at the end.
   *
   * @throws InputException when it is no row, or has another number of cells than the first
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

  /** Reads a row; false where there is none. */
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
    texts.add(plain ? text : text.strip());
  }

  private static long place(JsonLocation location) {
    return location == null
        ? CsvRow.place(1, 1)
        : CsvRow.place(Math.max(1, location.getLineNr()), Math.max(1, location.getColumnNr()));
  }

  /**
   * Hands over all rows that are left, one by one.
   *
   * @throws InputException when one is wrong
   */
  public void each(Consumer<CsvRow> taker) {
    for (CsvRow row = next(); row != null; row = next()) {
      taker.accept(row);
    }
  }

  /**
   * The whole table, then closed.
   *
   * @param required names of columns that it has to have
   * @throws InputException when a row is wrong, or the table is too big to be kept
   */
  public CsvRows all(List<String> required) {
    try (this) {
      List<String> names = header(required);
      List<CsvRow> rows = new ArrayList<>();
      each(
          row -> {
            rows.add(row);
            requireRoom();
          });
      return new CsvRows(file, names, rows);
    }
  }

  private void requireRoom() {
    if (parser.currentLocation().getCharOffset() > MAX_CHARACTERS) {
      throw start().error("the table is too big, expected at most 256 MiB");
    }
  }

  String file() {
    return file.toString();
  }

  /** A number with the decimal point that Java knows. */
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
