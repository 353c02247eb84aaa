package org.hificamsim.core;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * How enumeration constants are written in files and options: lower case, {@code -} for {@code _}.
 */
public final class Spelling {
  private Spelling() {}

  /** The constant's spelling. */
  public static String of(Enum<?> constant) {
    return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /** The constant of {@code type} spelled so. */
  public static <E extends Enum<E>> Optional<E> find(Class<E> type, String text) {
    return Arrays.stream(type.getEnumConstants())
        .filter(constant -> of(constant).equals(text))
        .findFirst();
  }

  /**
   * The constant of {@code type} that a text spells.
   *
   * @param name of what has the text, for the error line
   * @throws InputException when there is none
   */
  public static <E extends Enum<E>> E require(Class<E> type, String name, String text) {
    return find(type, text)
        .orElseThrow(
            () -> InputException.of("%s is '%s', expected one of %s", name, text, all(type)));
  }

  /** All spellings of {@code type}, for error lines. */
  public static <E extends Enum<E>> String all(Class<E> type) {
    return Arrays.stream(type.getEnumConstants())
        .map(Spelling::of)
        .collect(Collectors.joining(", "));
  }
}
