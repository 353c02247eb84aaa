package org.hificamsim.core;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/** Spells enumeration constants as files and options do: lower case, {@code -} for {@code _}. */
public final class Spelling {
  private Spelling() {}

  /** Returns the spelling of a constant. */
  public static String of(Enum<?> constant) {
    return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /** Returns the constant of {@code type} with this spelling. */
  public static <E extends Enum<E>> Optional<E> find(Class<E> type, String text) {
    return Arrays.stream(type.getEnumConstants())
        .filter(constant -> of(constant).equals(text))
        .findFirst();
  }

  /**
   * Returns the constant of {@code type} with this spelling.
   *
   * @param name the name of the setting, for the message
   * @throws InputException if there is none
   */
  public static <E extends Enum<E>> E require(Class<E> type, String name, String text) {
    return find(type, text)
        .orElseThrow(
            () -> InputException.of("%s is '%s', expected one of %s", name, text, all(type)));
  }

  /** Returns all spellings of {@code type}, for messages. */
  public static <E extends Enum<E>> String all(Class<E> type) {
    return Arrays.stream(type.getEnumConstants())
        .map(Spelling::of)
        .collect(Collectors.joining(", "));
  }
}
