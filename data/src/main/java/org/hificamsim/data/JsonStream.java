package org.hificamsim.data;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.core.io.JsonEOFException;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import java.io.ByteArrayInputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.function.Consumer;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.file.TextLines;

/**
 * Reads JSON token by token and reports errors with their line and column. NaN and the infinities
 * are read as numbers, so that callers can reject them with the name of the property.
 */
public final class JsonStream implements Closeable {
  private static final JsonFactory UNBOUNDED =
      JsonFactory.builder().enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS).build();
  private static final JsonFactory BOUNDED =
      JsonFactory.builder()
          .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
          .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
          .streamReadConstraints(
              StreamReadConstraints.builder().maxNestingDepth(50).maxTokenCount(500_000).build())
          .build();

  private final String file;
  private final JsonParser parser;

  private JsonStream(String file, JsonFactory factory, InputStream in) {
    this.file = file;
    try {
      parser = factory.createParser(in);
    } catch (IOException e) {
      throw TextLines.unreadable(file, 1, e);
    }
  }

  /**
   * Opens a file of any size; one whose name ends in {@code .gz} is decompressed.
   *
   * @throws InputException when it is missing or cannot be read
   */
  public static JsonStream open(Path path) {
    return new JsonStream(path.toString(), UNBOUNDED, TextLines.stream(path));
  }

  /**
   * Opens a text whose values are all kept in memory: limits its size and depth, and rejects
   * duplicate properties.
   *
   * @param file the name of the file in error messages
   */
  public static JsonStream bounded(String file, byte[] text) {
    return new JsonStream(file, BOUNDED, new ByteArrayInputStream(text));
  }

  private <T> T read(Io.Source<T> reading) {
    try {
      return reading.get();
    } catch (JsonProcessingException e) {
      JsonLocation location = e.getLocation() == null ? parser.currentLocation() : e.getLocation();
      throw new InputException(place(location).line(problem(e)), e);
    } catch (IOException e) {
      throw TextLines.unreadable(file, place().line(), e);
    }
  }

  private static String problem(JsonProcessingException e) {
    return e instanceof JsonEOFException
        ? "the file ends too early, expected the rest of what was opened"
        : "no valid JSON, expected a whole file, each property once: " + e.getOriginalMessage();
  }

  /** The next token; null at the end. */
  public JsonToken next() {
    return read(parser::nextToken);
  }

  /**
   * Reads the object that the last token began.
   *
   * @param expected the expected kind of value, for error messages
   * @param property receives the name of each property and reads its value; unread parts of objects
   *     and arrays are skipped
   */
  public void object(String expected, Consumer<String> property) {
    require(JsonToken.START_OBJECT, expected);
    while (nextProperty()) {
      String name = text();
      next();
      property.accept(name);
      skip();
    }
  }

  /**
   * Reads the array that the last token began.
   *
   * @param expected the expected kind of value, for error messages
   * @param item reads each value; unread parts of objects and arrays are skipped
   */
  public void array(String expected, Runnable item) {
    require(JsonToken.START_ARRAY, expected);
    while (next() != JsonToken.END_ARRAY) {
      item.run();
      skip();
    }
  }

  private void require(JsonToken token, String expected) {
    if (token() != token) {
      throw error("expected " + expected);
    }
  }

  /** Whether the last token began an object or array. */
  public boolean isBegun() {
    return token() == JsonToken.START_OBJECT || token() == JsonToken.START_ARRAY;
  }

  /**
   * Moves to the next property of an object and returns whether there is one; {@link #text} is then
   * its name.
   */
  public boolean nextProperty() {
    return next() != JsonToken.END_OBJECT;
  }

  /** Returns the name of the current property, or the text of the value that was read last. */
  public String text() {
    return read(parser::getText);
  }

  /** Returns the token that was read last. */
  public JsonToken token() {
    return parser.currentToken();
  }

  /** Skips the rest of the object or array that the last token began. */
  public void skip() {
    read(parser::skipChildren);
  }

  /** Returns the number that was read last; its absolute value must be at most 1e9. */
  public double coordinate(String name) {
    double value = number(name);
    if (Math.abs(value) > 1e9) {
      throw invalid(name, "a number from -1e9 to 1e9");
    }
    return value;
  }

  /** Returns the number that was read last, which must be finite. */
  public double number(String name) {
    double value = value();
    if (!Double.isFinite(value)) {
      throw invalid(name, "a finite number");
    }
    return value;
  }

  /** Returns the number that was read last; NaN if the token is not a number. */
  public double value() {
    boolean number = parser.currentToken() != null && parser.currentToken().isNumeric();
    return number ? read(parser::getDoubleValue) : Double.NaN;
  }

  /** Returns the error for the value that was read last. */
  public InputException invalid(String name, String expected) {
    return place().invalid(name, text(), expected);
  }

  /** Returns an error at the token that was read last. */
  public InputException error(String problem) {
    return place().error(problem);
  }

  /** Returns the place where the token that was read last begins. */
  public Place place() {
    return place(parser.currentTokenLocation());
  }

  private Place place(JsonLocation location) {
    return new Place(file, Math.max(1, location.getLineNr()), Math.max(1, location.getColumnNr()));
  }

  @Override
  public void close() {
    read(
        () -> {
          parser.close();
          return null;
        });
  }
}
