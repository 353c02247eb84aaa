package org.hificamsim.hifi.model;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Function;
import org.hificamsim.hifi.json.JsonObject;

/**
 * The types that one part of a model file may have. The property {@code type} says which it is, and
 * Jackson writes the other properties from its class.
 *
 * @param <T> what they have in common
 */
final class FormatTable<T> {
  private final Map<String, Function<JsonObject, ? extends T>> readers = new LinkedHashMap<>();
  private final Map<Class<? extends T>, String> types = new LinkedHashMap<>();

  /**
   * Adds a type.
   *
   * @param type the text of its property {@code type}
   * @param reader makes one from its properties; those that it does not ask for are refused
   */
  <S extends T> FormatTable<T> add(String type, Class<S> of, Function<JsonObject, S> reader) {
    readers.put(type, reader);
    types.put(of, type);
    return this;
  }

  T read(JsonObject json) {
    return readers.get(json.text("type", readers.keySet())).apply(json);
  }

  /**
   * The properties of an object, with its type first.
   *
   * @throws IllegalArgumentException where its class has not been added
   */
  ObjectNode json(T object) {
    String type = types.get(object.getClass());
    if (type == null) {
      throw new IllegalArgumentException(
          "no file format for %s, expected one of %s"
              .formatted(object.getClass().getName(), readers.keySet()));
    }
    return ModelWriter.MAPPER.createObjectNode().put("type", type).setAll(properties(object));
  }

  /** The properties of an object without its type. */
  static ObjectNode properties(Object object) {
    return ModelWriter.MAPPER.valueToTree(object);
  }
}
