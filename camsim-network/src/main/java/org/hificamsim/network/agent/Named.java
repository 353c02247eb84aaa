package org.hificamsim.network.agent;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * What scenario files and options call by a short name of ours or a class name of CamSim's
 * (behaviour 3.7).
 */
public interface Named {
  /** The short name, such as {@code Active}, then CamSim's class names, the current one first. */
  List<String> names();

  /**
   * The constant that {@code text} names: by its short name, a class name, or the last part of one,
   * in upper or lower case.
   */
  static <E extends Enum<E> & Named> Optional<E> find(Class<E> type, String text) {
    String wanted = plain(text);
    return Arrays.stream(type.getEnumConstants())
        .filter(constant -> constant.names().stream().anyMatch(name -> answers(name, wanted)))
        .findFirst();
  }

  /** What names a constant, for error lines. */
  static <E extends Enum<E> & Named> String expected(Class<E> type) {
    return Arrays.stream(type.getEnumConstants())
        .map(constant -> constant.names().get(0))
        .collect(Collectors.joining(", ", "one of ", " or a class name of CamSim's"));
  }

  private static boolean answers(String name, String wanted) {
    String plain = plain(name);
    String lastPart = plain(name.substring(name.lastIndexOf('.') + 1));
    return wanted.equals(plain) || wanted.equals(lastPart);
  }

  private static String plain(String name) {
    return name.strip().replace('$', '.').toLowerCase(Locale.ROOT);
  }
}
