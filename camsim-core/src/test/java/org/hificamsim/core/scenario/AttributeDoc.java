package org.hificamsim.core.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Property;

/**
 * What an element's documentation says of one or more of its attributes.
 *
 * @param attributes those that it is about
 * @param meaning what they say: Markdown
 * @param otherwise what holds without them; empty where their default says it
 */
record AttributeDoc(List<Property<?, ?>> attributes, String meaning, String otherwise) {
  /** What an element is. */
  static String summary(Element<?> element) {
    return element.doc().lines().findFirst().orElse("");
  }

  /** All of an element, in the order of its documentation, those without effect too. */
  static List<AttributeDoc> all(Element<?> element) {
    List<Property<?, ?>> left = new ArrayList<>(element.attributes());
    left.addAll(element.ignored());
    List<AttributeDoc> all = new ArrayList<>();
    for (String line : element.doc().lines().skip(1).toList()) {
      List<String> names = List.of(line.substring(0, line.indexOf(':')).split(", "));
      List<Property<?, ?>> its = left.stream().filter(one -> names.contains(one.name())).toList();
      left.removeAll(its);
      String[] said = line.substring(line.indexOf(':') + 1).strip().split(" \\| ");
      if (!its.isEmpty()) {
        all.add(new AttributeDoc(its, said[0], said.length > 1 ? said[1] : ""));
      }
    }
    if (!left.isEmpty()) {
      throw new IllegalStateException(
          "<" + element.name() + "> does not say what these are: " + left);
    }
    return all;
  }

  /** The attributes' names. */
  String named() {
    return attributes.stream().map(one -> "`" + one.name() + "`").collect(Collectors.joining(", "));
  }

  boolean hasEffect() {
    return attributes.get(0).number() >= 0;
  }

  boolean isRequired() {
    return attributes.get(0).isRequired();
  }

  /** What holds without them. */
  String standard() {
    if (isRequired()) {
      return "required";
    }
    Stream<String> own = attributes.stream().flatMap(AttributeDoc::standard).distinct();
    return otherwise.isEmpty() ? own.collect(Collectors.joining(", ")) : otherwise;
  }

  private static <T> Stream<String> standard(Property<?, T> attribute) {
    return Stream.ofNullable(attribute.standard())
        .map(value -> "`" + attribute.type().writer().apply(value).replaceFirst("\\.0$", "") + "`");
  }
}
