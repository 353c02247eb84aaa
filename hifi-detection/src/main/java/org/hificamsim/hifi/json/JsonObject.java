package org.hificamsim.hifi.json;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Predicate;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.hifi.json.JsonFile.Value;

/**
 * An object of a JSON file, read property by property.
 *
 * <p>Each getter declares one property with its type and range. It throws an {@link InputException}
 * with line and column if the property is missing, has another type or is out of range. {@link
 * #readWhole} rejects properties that no getter has declared.
 */
public final class JsonObject {
  record Property(Place place, Value value) {}

  private final Place place;
  private final Map<String, Property> properties;
  private final Set<String> declared = new LinkedHashSet<>();

  JsonObject(Place place, Map<String, Property> properties) {
    this.place = place;
    this.properties = properties;
  }

  /** Declares the property and returns whether the object has it. */
  public boolean has(String key) {
    declared.add(key);
    return properties.containsKey(key);
  }

  /** Returns a finite number in [{@code least}, {@code most}]. */
  public double number(String key, double least, double most) {
    String expected = "a number from " + least + " to " + most;
    return take(key, Double.class, value -> value >= least && value <= most, expected);
  }

  /** Returns a whole number that is one of {@code values}. */
  public int exactly(String key, List<Integer> values) {
    String expected = String.join(" or ", values.stream().map(String::valueOf).toList());
    Predicate<Double> known =
        value -> values.stream().anyMatch(allowed -> allowed.doubleValue() == value);
    return take(key, Double.class, known, expected).intValue();
  }

  /** Returns a whole number from 1 to {@code most}. */
  public int count(String key, int most) {
    double value = number(key, 1, most);
    if (value != Math.rint(value)) {
      throw error(key, "expected a whole number from 1 to " + most);
    }
    return (int) value;
  }

  /** Returns a text. */
  public String text(String key) {
    return take(key, String.class, text -> true, "a text");
  }

  /** Returns a text that is one of {@code choices}. */
  public String text(String key, List<String> choices) {
    return take(key, String.class, choices::contains, "one of " + String.join(", ", choices));
  }

  /** Reads an object, all of whose properties {@code reader} must declare. */
  public <T> T object(String key, Function<JsonObject, T> reader) {
    return take(key, JsonObject.class, object -> true, "an object").readWhole(reader);
  }

  /** Returns a list of objects. */
  public List<JsonObject> objects(String key) {
    List<JsonObject> objects = new ArrayList<>();
    for (Value item : take(key, Value[].class, list -> true, "a list of objects")) {
      if (!(item.content() instanceof JsonObject object)) {
        throw item.place().error(key + " holds " + item.shown() + ", expected objects alone");
      }
      objects.add(object);
    }
    return objects;
  }

  /**
   * Returns a list of rows, each a list of {@code columns} finite numbers in [{@code least}, {@code
   * most}].
   */
  public double[][] rows(String key, int columns, int mostRows, double least, double most) {
    String expected = "a list of 1 to " + mostRows + " rows";
    Predicate<Value[]> withinLimit = rows -> rows.length > 0 && rows.length <= mostRows;
    return Arrays.stream(take(key, Value[].class, withinLimit, expected))
        .map(row -> row(key, row, columns, least, most))
        .toArray(double[][]::new);
  }

  /** Returns a list of exactly {@code count} finite numbers in [{@code least}, {@code most}]. */
  public double[] numbers(String key, int count, double least, double most) {
    return row(key, value(key, "a list of " + count + " numbers"), count, least, most);
  }

  private static double[] row(String key, Value row, int columns, double least, double most) {
    if (!(row.content() instanceof Value[] cells) || cells.length != columns) {
      throw row.place()
          .error(key + " holds " + row.shown() + ", expected lists of " + columns + " numbers");
    }
    double[] values = new double[columns];
    for (int i = 0; i < columns; i++) {
      Value cell = cells[i];
      if (!(cell.content() instanceof Double number && number >= least && number <= most)) {
        throw cell.place()
            .error("%s holds %s, expected numbers from %s to %s", key, cell.shown(), least, most);
      }
      values[i] = number;
    }
    return values;
  }

  /** Returns every property, which must be a text, in the order of the file. */
  public Map<String, String> texts() {
    Map<String, String> texts = new LinkedHashMap<>();
    properties.keySet().forEach(key -> texts.put(key, text(key)));
    return texts;
  }

  /**
   * Returns the error for a property's value, with its line and column.
   *
   * @param expectation what was expected, a phrase that starts with "expected"
   */
  public InputException error(String key, String expectation) {
    Value value = properties.get(key).value();
    return value
        .place()
        .error(JsonFile.shortened(key) + " is " + value.shown() + ", " + expectation);
  }

  /** Reads this object; rejects properties that {@code reader} did not declare. */
  public <T> T readWhole(Function<JsonObject, T> reader) {
    T result = reader.apply(this);
    properties.forEach(this::checkDeclared);
    return result;
  }

  private void checkDeclared(String key, Property property) {
    if (!declared.contains(key)) {
      throw property
          .place()
          .error(
              "unknown property '%s', expected one of %s",
              JsonFile.shortened(key), String.join(", ", declared));
    }
  }

  private <T> T take(String key, Class<T> type, Predicate<T> valid, String expected) {
    Object value = value(key, expected).content();
    if (type.isInstance(value) && valid.test(type.cast(value))) {
      return type.cast(value);
    }
    throw error(key, "expected " + expected);
  }

  private Value value(String key, String expected) {
    if (!has(key)) {
      throw place.error("property '" + key + "' is missing, expected " + expected);
    }
    return properties.get(key).value();
  }
}
