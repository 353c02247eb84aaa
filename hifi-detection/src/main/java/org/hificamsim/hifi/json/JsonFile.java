package org.hificamsim.hifi.json;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.core.io.JsonEOFException;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import java.io.CharConversionException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;

/**
 * A JSON text read once, front to back, into values that know their place. Twice-given properties,
 * text after the end and deep nesting are refused; NaN and the infinities are read as numbers, for
 * {@link JsonObject} to refuse by name.
 */
public final class JsonFile {
  private static final JsonFactory FACTORY =
      JsonFactory.builder()
          .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
          .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
          .streamReadConstraints(
              StreamReadConstraints.builder().maxNestingDepth(50).maxTokenCount(500_000).build())
          .build();

  private final String file;
  private final JsonParser parser;

  private JsonFile(String file, JsonParser parser) {
    this.file = file;
    this.parser = parser;
  }

  /**
   * Reads a file's bytes as one object.
   *
   * @param file the file's name in error lines
   * @throws InputException with the place, when they are not one JSON object
   */
  public static JsonObject parse(String file, byte[] bytes) {
    try (JsonParser parser = FACTORY.createParser(bytes)) {
      return new JsonFile(file, parser).whole();
    } catch (CharConversionException e) {
      throw new InputException(
          new Place(file, 1, 1) + ": no text, expected a JSON object in UTF-8", e);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private JsonObject whole() throws IOException {
    try {
      return onlyObject();
    } catch (JsonProcessingException e) {
      JsonLocation location = e.getLocation();
      throw place(location == null ? parser.currentLocation() : location).error(problem(e));
    }
  }

  private JsonObject onlyObject() throws IOException {
    if (parser.nextToken() == null) {
      throw new Place(file, 1, 1).error("the file is empty, expected a JSON object");
    }
    JsonValue value = value();
    if (!(value instanceof JsonObject object)) {
      throw value.place().error("the file holds " + value.shown() + ", expected an object in {}");
    }
    if (parser.nextToken() != null) {
      throw place().error(value().shown() + " after the end, expected nothing more");
    }
    return object;
  }

  private JsonValue value() throws IOException {
    Place place = place();
    JsonToken token = parser.currentToken();
    return switch (token) {
      case START_OBJECT -> object(place);
      case START_ARRAY -> items(place);
      case VALUE_STRING -> new JsonValue.Text(place, parser.getText());
      case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT ->
          new JsonValue.Numeral(place, parser.getDoubleValue(), parser.getText());
      default -> new JsonValue.Word(place, parser.getText());
    };
  }

  private JsonObject object(Place place) throws IOException {
    Map<String, JsonObject.Property> properties = new LinkedHashMap<>();
    while (parser.nextToken() != JsonToken.END_OBJECT) {
      String key = parser.currentName();
      Place keyPlace = place();
      parser.nextToken();
      properties.put(key, new JsonObject.Property(keyPlace, value()));
    }
    return new JsonObject(place, properties);
  }

  private JsonValue items(Place place) throws IOException {
    List<JsonValue> values = new ArrayList<>();
    while (parser.nextToken() != JsonToken.END_ARRAY) {
      values.add(value());
    }
    return new JsonValue.Items(place, values);
  }

  private Place place() {
    return place(parser.currentTokenLocation());
  }

  private Place place(JsonLocation location) {
    return new Place(file, location.getLineNr(), location.getColumnNr());
  }

  private static String problem(JsonProcessingException e) {
    return e instanceof JsonEOFException
        ? "the file ends too early, expected the rest of what was opened"
        : "no valid JSON, expected one object in {}, each property once: " + e.getOriginalMessage();
  }
}
