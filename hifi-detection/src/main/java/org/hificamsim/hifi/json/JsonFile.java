package org.hificamsim.hifi.json;

import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.data.JsonStream;

/**
 * Reads a JSON text into values that know their line and column. Duplicate properties, text after
 * the end and deep nesting are rejected. NaN and the infinities are read as numbers, so that {@link
 * JsonObject} can reject them with the name of the property.
 */
public final class JsonFile {
  /**
   * A value in a JSON file.
   *
   * @param content a {@link JsonObject}, an array of values, a text or a number; for true, false
   *     and null the token
   * @param shown the text that error messages show for the value
   */
  record Value(Place place, Object content, String shown) {}

  private final JsonStream json;

  private JsonFile(JsonStream json) {
    this.json = json;
  }

  /**
   * Reads a file's bytes as one object.
   *
   * @param file the file's name in error messages
   * @throws InputException with line and column, when the bytes are not one JSON object
   */
  public static JsonObject parse(String file, byte[] bytes) {
    try (JsonStream json = JsonStream.bounded(file, bytes)) {
      if (json.next() == null) {
        throw new Place(file, 1, 1).error("the file is empty, expected a JSON object");
      }
      return new JsonFile(json).readObject();
    }
  }

  /**
   * Reads a file as one object.
   *
   * @param expected the expected kind of file, for error messages
   * @param maxBytes the largest size that is read
   * @throws InputException when the file cannot be read, or, with line and column, when it is not
   *     one JSON object
   */
  public static JsonObject read(Path file, String expected, int maxBytes) {
    try (InputStream in = Files.newInputStream(file)) {
      byte[] bytes = in.readNBytes(maxBytes + 1);
      if (bytes.length > maxBytes) {
        throw new Place(file.toString(), 1, 1)
            .error("the file is too big, expected at most " + maxBytes + " bytes");
      }
      return parse(file.toString(), bytes);
    } catch (NoSuchFileException e) {
      throw new InputException(file + ": no such file, expected " + expected, e);
    } catch (IOException e) {
      throw new InputException(file + ": cannot be read, expected " + expected + ": " + e, e);
    }
  }

  private JsonObject readObject() {
    Value value = value();
    if (!(value.content() instanceof JsonObject object)) {
      throw value.place().error("the file holds " + value.shown() + ", expected an object in {}");
    }
    if (json.next() != null) {
      Place extra = json.place();
      throw extra.error(value().shown() + " after the end, expected nothing more");
    }
    return object;
  }

  private Value value() {
    Place place = json.place();
    return switch (json.token()) {
      case START_OBJECT -> new Value(place, object(place), "an object");
      case START_ARRAY -> items(place);
      case VALUE_STRING -> new Value(place, json.text(), "'" + shortened(json.text()) + "'");
      case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT ->
          new Value(place, json.value(), shortened(json.text()));
      default -> new Value(place, json.token(), json.text());
    };
  }

  private JsonObject object(Place place) {
    Map<String, JsonObject.Property> properties = new LinkedHashMap<>();
    while (json.nextProperty()) {
      String key = json.text();
      Place keyPlace = json.place();
      json.next();
      properties.put(key, new JsonObject.Property(keyPlace, value()));
    }
    return new JsonObject(place, properties);
  }

  private Value items(Place place) {
    List<Value> values = new ArrayList<>();
    while (json.next() != JsonToken.END_ARRAY) {
      values.add(value());
    }
    return new Value(place, values.toArray(Value[]::new), "a list of " + values.size());
  }

  /** Returns the text, cut to 60 characters and an ellipsis if it is longer. */
  static String shortened(String text) {
    return text.length() <= 60 ? text : text.substring(0, 60) + "...";
  }
}
