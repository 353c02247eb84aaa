package org.hificamsim.core.scenario;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.regex.Pattern;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;

/**
 * The attributes of one element, read by name, type and range; what was not read is left over.
 *
 * <p>Each getter that finds something wrong throws an {@link InputException} that names the place,
 * the value and what was expected.
 */
final class Attributes {
  /** Characters of a value that an error line shows. */
  static final int MAX_QUOTED = 60;

  private static final Pattern XML_OWN = Pattern.compile("xmlns(:.*)?|xml:.*|xsi:.*");

  private final XmlElement element;
  private final Map<String, String> rest;

  Attributes(XmlElement element) {
    this.element = element;
    this.rest = new LinkedHashMap<>(element.attributes());
  }

  /** A finite number. */
  double number(String name) {
    return number(name, Range.FINITE);
  }

  /** A number in a range. */
  double number(String name, Range range) {
    return parse(name, required(name, range.expected()), range);
  }

  /** A number in a range; empty where the attribute is missing. */
  OptionalDouble optionalNumber(String name, Range range) {
    String text = rest.remove(name);
    return text == null ? OptionalDouble.empty() : OptionalDouble.of(parse(name, text, range));
  }

  int integer(String name, int min, int max) {
    String expected = wholeNumber(min, max);
    return parse(name, required(name, expected), min, max);
  }

  OptionalInt optionalInteger(String name, int min, int max) {
    String text = rest.remove(name);
    return text == null ? OptionalInt.empty() : OptionalInt.of(parse(name, text, min, max));
  }

  /** Whether the file gives an attribute that has not been read. */
  boolean has(String name) {
    return rest.containsKey(name);
  }

  /** An error where the file gives an attribute that has no place here. */
  void refuse(String name, String expected) {
    if (has(name)) {
      throw invalid(name, expected);
    }
  }

  /** Any text, even none. */
  String text(String name, String expected) {
    return required(name, expected);
  }

  Optional<String> optionalText(String name) {
    return Optional.ofNullable(rest.remove(name));
  }

  /**
   * A value that another class reads; empty where the attribute is missing.
   *
   * @param parser says in an InputException what it expected
   */
  <T> Optional<T> optional(String name, Function<String, T> parser) {
    try {
      return optionalText(name).map(parser);
    } catch (InputException e) {
      throw element.place(name).error("<" + element.name() + "> " + e.getMessage());
    }
  }

  /** A constant, written in lower case with {@code -} for {@code _}. */
  <E extends Enum<E>> E choice(String name, E defaultValue) {
    String text = rest.remove(name);
    if (text == null) {
      return defaultValue;
    }
    Class<E> type = defaultValue.getDeclaringClass();
    return Spelling.find(type, text)
        .orElseThrow(() -> invalid(name, "one of " + Spelling.all(type)));
  }

  /**
   * What was not read; each is a warning, except for those that are {@code known} to have no
   * effect, and for XML's own: names with a prefix belong to others and are left out.
   */
  Map<String, String> leftOver(Consumer<String> warnings, String... known) {
    rest.keySet().removeIf(XML_OWN.asMatchPredicate());
    for (Map.Entry<String, String> one : rest.entrySet()) {
      if (!Arrays.asList(known).contains(one.getKey())) {
        warnings.accept(
            element.place(one.getKey())
                + ": unknown attribute "
                + one.getKey()
                + "=\""
                + XmlText.shortened(one.getValue(), MAX_QUOTED)
                + "\" of <"
                + element.name()
                + ">, ignored");
      }
    }
    rest.keySet().removeIf(name -> name.contains(":"));
    Map<String, String> kept = Map.copyOf(rest);
    rest.clear();
    return kept;
  }

  /** An error about one attribute's value, or that it has none. */
  InputException invalid(String name, String expected) {
    if (!element.attributes().containsKey(name)) {
      return element
          .place()
          .error("<" + element.name() + "> has no " + name + ", expected " + expected);
    }
    return element
        .place(name)
        .error(
            "<"
                + element.name()
                + "> "
                + name
                + " is '"
                + XmlText.shortened(element.attributes().get(name), MAX_QUOTED)
                + "', expected "
                + expected);
  }

  private String required(String name, String expected) {
    String text = rest.remove(name);
    if (text == null) {
      throw invalid(name, expected);
    }
    return text;
  }

  private double parse(String name, String text, Range range) {
    try {
      double value = Double.parseDouble(text);
      if (range.contains(value)) {
        return value;
      }
    } catch (NumberFormatException e) {
      // reported below
    }
    throw invalid(name, range.expected());
  }

  private int parse(String name, String text, int min, int max) {
    try {
      int value = Integer.parseInt(text);
      if (value >= min && value <= max) {
        return value;
      }
    } catch (NumberFormatException e) {
      // reported below
    }
    throw invalid(name, wholeNumber(min, max));
  }

  private static String wholeNumber(int min, int max) {
    return max == Integer.MAX_VALUE
        ? "a whole number of " + min + " or more"
        : "a whole number from " + min + " to " + max;
  }
}
