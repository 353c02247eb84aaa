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
 * JSON token by token; faults have their place. NaN and the infinities are read as numbers, so that
 * callers can refuse them by name.
 */
public final class JsonStream implements Closeable {
  private static final JsonFactory ANY_SIZE =
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
   * Opens a file of any size, unpacked where its name ends in {@code .gz}.
   *
   * @throws InputException when it is missing or cannot be read
   */
  public static JsonStream open(Path path) {
    return new JsonStream(path.toString(), ANY_SIZE, TextLines.stream(path));
  }

  /**
   * Text that is to be kept as a whole: bounded, not deep, each property of an object once.
   *
   * @param file its name in error lines
   */
  public static JsonStream bounded(String file, byte[] text) {
    return new JsonStream(file, BOUNDED, new ByteArrayInputStream(text));
  }

  private <T> T read(Io.Source<T> reading) {
    try {
      return reading.get();
    } catch (JsonProcessingException e) {
      JsonLocation at = e.getLocation() == null ? parser.currentLocation() : e.getLocation();
      throw new InputException(place(at).line(problem(e)), e);
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
   * Reads an object that was begun.
   *
   * @param expected what it has to be, in error lines
   * @param property takes the name of each property, whose value is then being read; what it leaves
   *     of that is passed over
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
   * Reads an array that was begun.
   *
   * @param expected what it has to be, in error lines
   * @param item is called for each value; what it leaves of that is passed over
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

  /** Whether an object or array was begun. */
  public boolean isBegun() {
    return token() == JsonToken.START_OBJECT || token() == JsonToken.START_ARRAY;
  }

  /** Whether the next token begins the next property of an object, whose name is then the text. */
  public boolean nextProperty() {
    return next() != JsonToken.END_OBJECT;
  }

  /** The name of the property that was begun, or the text of the value that was read. */
  public String text() {
    return read(parser::getText);
  }

  /** The token that was read last. */
  public JsonToken token() {
    return parser.currentToken();
  }

  /** Leaves out the rest of an object or array that was begun. */
  public void skip() {
    read(parser::skipChildren);
  }

  /** The number that was read last: at most 1e9 in size. */
  public double coordinate(String name) {
    double value = number(name);
    if (Math.abs(value) > 1e9) {
      throw invalid(name, "a number from -1e9 to 1e9");
    }
    return value;
  }

  /** The finite number that was read last. */
  public double number(String name) {
    double value = value();
    if (!Double.isFinite(value)) {
      throw invalid(name, "a finite number");
    }
    return value;
  }

  /** The number that was read last; NaN where it is none. */
  public double value() {
    boolean number = parser.currentToken() != null && parser.currentToken().isNumeric();
    return number ? read(parser::getDoubleValue) : Double.NaN;
  }

  /** The fault of the value that was read last. */
  public InputException invalid(String name, String expected) {
    return place().invalid(name, text(), expected);
  }

  /** A fault at the token that was read last. */
  public InputException error(String problem) {
    return place().error(problem);
  }

  /** Where the token that was read last begins. */
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
