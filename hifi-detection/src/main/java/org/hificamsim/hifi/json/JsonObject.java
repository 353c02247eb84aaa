package org.hificamsim.hifi.json;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;

/**
 * An object of a JSON file, read property by property.
 *
 * <p>Each getter declares one property, its type and range; one that is missing, of another type or
 * out of range is an {@link InputException} with its place. {@link #whole} refuses what nobody
 * declared.
 */
public final class JsonObject implements JsonValue {
  record Property(Place place, JsonValue value) {}

  private final Place place;
  private final Map<String, Property> properties;
  private final Set<String> declared = new LinkedHashSet<>();

  JsonObject(Place place, Map<String, Property> properties) {
    this.place = place;
    this.properties = properties;
  }

  @Override
  public Place place() {
    return place;
  }

  @Override
  public String shown() {
    return "an object";
  }

  /** Whether the property is there. */
  public boolean has(String key) {
    declared.add(key);
    return properties.containsKey(key);
  }

  /** A finite number in [{@code least}, {@code most}]. */
  public double number(String key, double least, double most) {
    String expected = "a number from " + least + " to " + most;
    if (take(key, expected) instanceof Numeral numeral
        && numeral.value() >= least
        && numeral.value() <= most) {
      return numeral.value();
    }
    throw wrong(key, expected);
  }

  /** A whole number that is one of {@code values}. */
  public int exactly(String key, int... values) {
    String expected =
        Arrays.stream(values).mapToObj(Integer::toString).collect(Collectors.joining(" or "));
    if (take(key, expected) instanceof Numeral numeral) {
      for (int value : values) {
        if (numeral.value() == value) {
          return value;
        }
      }
    }
    throw wrong(key, expected);
  }

  /** A whole number from 1 to {@code most}. */
  public int count(String key, int most) {
    double value = number(key, 1, most);
    if (value != Math.rint(value)) {
      throw wrong(key, "a whole number from 1 to " + most);
    }
    return (int) value;
  }

  /** A text. */
  public String text(String key) {
    return text(key, "a text");
  }

  /** A text that is one of {@code choices}. */
  public String text(String key, Iterable<String> choices) {
    String expected = "one of " + String.join(", ", choices);
    String text = text(key, expected);
    for (String choice : choices) {
      if (choice.equals(text)) {
        return text;
      }
    }
    throw wrong(key, expected);
  }

  /** An object. */
  public JsonObject object(String key) {
    if (take(key, "an object") instanceof JsonObject object) {
      return object;
    }
    throw wrong(key, "an object");
  }

  /** A list of objects. */
  public List<JsonObject> objects(String key) {
    if (!(take(key, "a list of objects") instanceof Items items)) {
      throw wrong(key, "a list of objects");
    }
    List<JsonObject> objects = new ArrayList<>();
    for (JsonValue item : items.values()) {
      if (!(item instanceof JsonObject object)) {
        throw item.place().error(key + " holds " + item.shown() + ", expected objects alone");
      }
      objects.add(object);
    }
    return objects;
  }

  /**
   * A list of rows, each a list of {@code columns} finite numbers in [{@code least}, {@code most}].
   */
  public double[][] rows(String key, int columns, int mostRows, double least, double most) {
    String expected = "a list of 1 to " + mostRows + " rows";
    if (!(take(key, expected) instanceof Items items)
        || items.values().isEmpty()
        || items.values().size() > mostRows) {
      throw wrong(key, expected);
    }
    return items.values().stream()
        .map(row -> row(key, row, columns, least, most))
        .toArray(double[][]::new);
  }

  /** A list of exactly {@code count} finite numbers in [{@code least}, {@code most}]. */
  public double[] numbers(String key, int count, double least, double most) {
    return row(key, take(key, "a list of " + count + " numbers"), count, least, most);
  }

  private static double[] row(String key, JsonValue row, int columns, double least, double most) {
    if (!(row instanceof Items cells) || cells.values().size() != columns) {
      throw row.place()
          .error(key + " holds " + row.shown() + ", expected lists of " + columns + " numbers");
    }
    double[] values = new double[columns];
    for (int i = 0; i < columns; i++) {
      JsonValue cell = cells.values().get(i);
      if (!(cell instanceof Numeral number)
          || !(number.value() >= least && number.value() <= most)) {
        throw cell.place()
            .error(
                "%s holds %s, expected numbers from %s to %s"
                    .formatted(key, cell.shown(), least, most));
      }
      values[i] = number.value();
    }
    return values;
  }

  /** Every property as a text, in the order of the file. */
  public Map<String, String> texts() {
    Map<String, String> texts = new LinkedHashMap<>();
    properties.keySet().forEach(key -> texts.put(key, text(key)));
    return texts;
  }

  /**
   * The fault of a property's value, at its place.
   *
   * @param expectation what was expected of it, starting with that word
   */
  public InputException error(String key, String expectation) {
    JsonValue value = properties.get(key).value();
    return value
        .place()
        .error(JsonValue.shortened(key) + " is " + value.shown() + ", " + expectation);
  }

  /** What a form makes of this object; refuses properties that it did not ask for. */
  public <T> T whole(Function<JsonObject, T> form) {
    T whole = form.apply(this);
    properties.forEach(this::checkDeclared);
    return whole;
  }

  private void checkDeclared(String key, Property property) {
    if (!declared.contains(key)) {
      throw property
          .place()
          .error(
              "unknown property '%s', expected one of %s"
                  .formatted(JsonValue.shortened(key), String.join(", ", declared)));
    }
  }

  private InputException wrong(String key, String expected) {
    return error(key, "expected " + expected);
  }

  private String text(String key, String expected) {
    if (take(key, expected) instanceof Text text) {
      return text.text();
    }
    throw wrong(key, expected);
  }

  private JsonValue take(String key, String expected) {
    if (!has(key)) {
      throw place.error("property '" + key + "' is missing, expected " + expected);
    }
    return properties.get(key).value();
  }
}
