package org.hificamsim.network.agent;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * A constant that scenario files and options select by a short name or by a class name of CamSim's
 * (behaviour 3.7).
 */
public interface Named {
  /** The short name, such as {@code Active}, then CamSim's class names, the current one first. */
  List<String> names();

  /**
   * Finds a constant by its short name, a class name, or the last part of a class name, ignoring
   * case.
   */
  static <E extends Enum<E> & Named> Optional<E> find(Class<E> type, String text) {
    String wanted = plain(text);
    return Arrays.stream(type.getEnumConstants())
        .filter(constant -> constant.names().stream().anyMatch(name -> matches(name, wanted)))
        .findFirst();
  }

  /** Lists the accepted names, for error messages. */
  static <E extends Enum<E> & Named> String expected(Class<E> type) {
    return Arrays.stream(type.getEnumConstants())
        .map(constant -> constant.names().get(0))
        .collect(Collectors.joining(", ", "one of ", " or a class name of CamSim's"));
  }

  private static boolean matches(String name, String wanted) {
    String plain = plain(name);
    String lastPart = plain(name.substring(name.lastIndexOf('.') + 1));
    return wanted.equals(plain) || wanted.equals(lastPart);
  }

  private static String plain(String name) {
    return name.strip().replace('$', '.').toLowerCase(Locale.ROOT);
  }
}
