package org.hificamsim.tracks.format;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.TextLines;

/** JSON of any size, token by token; faults have their place. */
public final class JsonStream implements Closeable {
  private static final JsonFactory FACTORY =
      JsonFactory.builder().enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS).build();

  private final String file;
  private final JsonParser parser;

  /**
   * Opens a file.
   *
   * @throws InputException when it is missing or cannot be read
   */
  public JsonStream(Path path) {
    file = path.toString();
    try {
      parser = FACTORY.createParser(TextLines.stream(path));
    } catch (IOException e) {
      throw TextLines.unreadable(file, 1, e);
    }
  }

  /** The next token; null at the end. */
  public JsonToken next() {
    try {
      return parser.nextToken();
    } catch (JsonProcessingException e) {
      throw fault(e);
    } catch (IOException e) {
      throw TextLines.unreadable(file, place().line(), e);
    }
  }

  private InputException fault(JsonProcessingException e) {
    JsonLocation at = e.getLocation() == null ? parser.currentLocation() : e.getLocation();
    return new InputException(
        place(at).line("not JSON, or cut off, expected a whole file: " + e.getOriginalMessage()),
        e);
  }

  /** Whether the next token begins the next property of an object, whose name is then the text. */
  public boolean nextProperty() {
    JsonToken token = next();
    if (token == null) {
      throw error("the file ends inside an object, expected }");
    }
    return token != JsonToken.END_OBJECT;
  }

  /** The name of the property that was begun, or the text of the value that was read. */
  public String text() {
    try {
      return parser.getText();
    } catch (IOException e) {
      throw TextLines.unreadable(file, place().line(), e);
    }
  }

  /** The token that was read last. */
  public JsonToken token() {
    return parser.currentToken();
  }

  /** Leaves out the rest of an object or array that was begun. */
  public void skip() {
    try {
      parser.skipChildren();
    } catch (JsonProcessingException e) {
      throw fault(e);
    } catch (IOException e) {
      throw TextLines.unreadable(file, place().line(), e);
    }
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
    try {
      if (parser.currentToken() != null && parser.currentToken().isNumeric()) {
        double value = parser.getDoubleValue();
        if (Double.isFinite(value)) {
          return value;
        }
      }
    } catch (IOException e) {
      // too large for a number
    }
    throw invalid(name, "a finite number");
  }

  /** The fault of the value that was read last. */
  public InputException invalid(String name, String expected) {
    String shown = text();
    String quoted = shown.length() > 60 ? shown.substring(0, 60) + "..." : shown;
    return error(name + " is '" + quoted + "', expected " + expected);
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
    try {
      parser.close();
    } catch (IOException e) {
      throw TextLines.unreadable(file, 1, e);
    }
  }
}
