package org.hificamsim.network.agent;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Something that scenario files and options name by one of CamSim's class names (behaviour 3.7).
 */
public interface Named {
  /** The name to write today, such as {@code Active}. */
  String shortName();

  /** CamSim's names for it, the current one first; any of them is understood. */
  List<String> classNames();

  /**
   * The constant that {@code text} names: in full, by the last part of a class name, or shortly;
   * upper and lower case are the same.
   */
  static <E extends Enum<E> & Named> Optional<E> find(Class<E> type, String text) {
    String wanted = plain(text);
    return Arrays.stream(type.getEnumConstants())
        .filter(constant -> answers(constant, wanted))
        .findFirst();
  }

  /** All short names, for error lines. */
  static <E extends Enum<E> & Named> String all(Class<E> type) {
    return Arrays.stream(type.getEnumConstants())
        .map(Named::shortName)
        .collect(Collectors.joining(", "));
  }

  private static boolean answers(Named named, String wanted) {
    return wanted.equals(plain(named.shortName()))
        || named.classNames().stream()
            .anyMatch(name -> wanted.equals(plain(name)) || wanted.equals(plain(lastPart(name))));
  }

  private static String plain(String name) {
    return name.strip().replace('$', '.').toLowerCase(Locale.ROOT);
  }

  private static String lastPart(String className) {
    return className.substring(className.lastIndexOf('.') + 1);
  }
}
