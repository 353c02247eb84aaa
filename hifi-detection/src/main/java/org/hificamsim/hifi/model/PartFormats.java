package org.hificamsim.hifi.model;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import org.hificamsim.core.Texts;
import org.hificamsim.hifi.json.JsonObject;

/**
 * The types of one part of a model, f or g, that JSON files may hold.
 *
 * @param formats the known types, in the order in which error messages list them
 */
record PartFormats<T>(List<Format<T>> formats) {
  /**
   * The JSON format of one type.
   *
   * @param type the text of its property {@code type}
   * @param javaType the class, whose properties Jackson writes
   * @param reader makes an instance from the properties and declares each of them
   */
  record Format<T>(String type, Class<? extends T> javaType, Function<JsonObject, T> reader) {}

  T read(JsonObject json) {
    String type = json.text("type", formats.stream().map(Format::type).toList());
    return format(format -> format.type().equals(type)).orElseThrow().reader().apply(json);
  }

  ObjectNode json(T part) {
    Format<T> format =
        format(candidate -> candidate.javaType().isInstance(part))
            .orElseThrow(
                () ->
                    new IllegalArgumentException(
                        Texts.format(
                            "no file format for %s, expected a line in FeatureFormats or"
                                + " DetectorFormats",
                            part.getClass().getName())));
    ObjectNode json = ModelFiles.MAPPER.createObjectNode().put("type", format.type());
    return json.setAll(ModelFiles.MAPPER.<ObjectNode>valueToTree(part));
  }

  private Optional<Format<T>> format(Predicate<Format<T>> wanted) {
    return formats.stream().filter(wanted).findFirst();
  }
}
