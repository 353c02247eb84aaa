package org.hificamsim.core.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Property;

/**
 * The documentation of one or more attributes of an element.
 *
 * @param attributes the documented attributes
 * @param meaning their meaning, in Markdown
 * @param otherwise what applies without them; empty if their default value says so
 */
record AttributeDoc(List<Property<?, ?>> attributes, String meaning, String otherwise) {
  /** Returns the first line of an element's documentation: what the element is. */
  static String summary(Element<?> element) {
    return element.doc().lines().findFirst().orElse("");
  }

  /** Returns all attributes of an element in documented order, including those without effect. */
  static List<AttributeDoc> all(Element<?> element) {
    List<Property<?, ?>> left = new ArrayList<>(element.attributes());
    left.addAll(element.ignored());
    List<AttributeDoc> docs = new ArrayList<>();
    for (String line : element.doc().lines().skip(1).toList()) {
      List<String> names = List.of(line.substring(0, line.indexOf(':')).split(", "));
      List<Property<?, ?>> described =
          left.stream().filter(attribute -> names.contains(attribute.name())).toList();
      left.removeAll(described);
      String[] parts = line.substring(line.indexOf(':') + 1).strip().split(" \\| ");
      if (!described.isEmpty()) {
        docs.add(new AttributeDoc(described, parts[0], parts.length > 1 ? parts[1] : ""));
      }
    }
    if (!left.isEmpty()) {
      throw new IllegalStateException(
          "<" + element.name() + "> does not say what these are: " + left);
    }
    return docs;
  }

  /** Returns the names of the attributes, in Markdown. */
  String named() {
    return attributes.stream()
        .map(attribute -> "`" + attribute.name() + "`")
        .collect(Collectors.joining(", "));
  }

  boolean hasEffect() {
    return attributes.get(0).number() >= 0;
  }

  boolean isRequired() {
    return attributes.get(0).isRequired();
  }

  /** Returns what applies without the attributes. */
  String defaultValue() {
    if (isRequired()) {
      return "required";
    }
    Stream<String> defaults = attributes.stream().flatMap(AttributeDoc::standard).distinct();
    return otherwise.isEmpty() ? defaults.collect(Collectors.joining(", ")) : otherwise;
  }

  private static <T> Stream<String> standard(Property<?, T> attribute) {
    return Stream.ofNullable(attribute.defaultValue())
        .map(value -> "`" + attribute.type().writer().apply(value).replaceFirst("\\.0$", "") + "`");
  }
}
